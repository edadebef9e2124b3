#include "stepmill/batch/part_order.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace stepmill {
namespace {

using Needs = std::vector<std::vector<std::string>>;

/// Tools put in at least from a part on, by trying every tool to take out.
int leastLoads(const Needs& needs, const std::vector<std::size_t>& order, std::size_t turn,
               std::set<std::string> inside, std::size_t places) {
    if (turn == order.size()) return 0;
    const std::set<std::string> needed(needs[order[turn]].begin(), needs[order[turn]].end());
    int loads = 0;
    for (const std::string& tool : needed)
        loads += inside.insert(tool).second ? 1 : 0;
    std::vector<std::string> spare;
    for (const std::string& tool : inside)
        if (!needed.contains(tool)) spare.push_back(tool);
    const std::size_t kept = std::min(spare.size(), places - needed.size());
    std::vector<bool> keep(spare.size(), false);
    std::fill(keep.end() - static_cast<std::ptrdiff_t>(kept), keep.end(), true);
    int least = std::numeric_limits<int>::max();
    do {
        std::set<std::string> next = needed;
        for (std::size_t i = 0; i < spare.size(); ++i)
            if (keep[i]) next.insert(spare[i]);
        least = std::min(least, leastLoads(needs, order, turn + 1, next, places));
    } while (std::next_permutation(keep.begin(), keep.end()));
    return loads + least;
}

/// Over every order too.
int byEnumeration(const Needs& needs, std::size_t places) {
    std::vector<std::size_t> order(needs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    int least = std::numeric_limits<int>::max();
    do {
        least = std::min(least, leastLoads(needs, order, 0, {}, places));
    } while (std::next_permutation(order.begin(), order.end()));
    return least;
}

Needs randomNeeds(std::mt19937& dice, std::size_t parts, int tools, int most) {
    std::uniform_int_distribution<int> tool(0, tools - 1);
    std::uniform_int_distribution<int> count(1, most);
    Needs needs(parts);
    for (auto& ids : needs) {
        std::set<std::string> set;
        for (int i = count(dice); i > 0; --i)
            set.insert("T" + std::to_string(tool(dice)));
        ids.assign(set.begin(), set.end());
    }
    return needs;
}

TEST(PartOrders, PutInAsFewToolsAsAnyOrderCan) {
    for (unsigned seed = 0; seed < 25; ++seed) {
        std::mt19937 dice(seed);
        const Needs needs = randomNeeds(dice, 5, 6, 3);
        const PartOrder found = orderParts(needs, 3);
        EXPECT_EQ(found.loads, byEnumeration(needs, 3)) << seed;
        EXPECT_EQ(found.bound, found.loads) << seed;
    }
}

TEST(PartOrders, HoldEveryPartOnceAndABoundThatHolds) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        std::mt19937 dice(seed);
        const Needs needs = randomNeeds(dice, 40, 15, 6);
        const PartOrder found = orderParts(needs, 6);
        std::vector<std::size_t> parts = found.parts;
        std::sort(parts.begin(), parts.end());
        std::vector<std::size_t> all(needs.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        EXPECT_EQ(parts, all);
        EXPECT_LE(found.bound, found.loads);
        EXPECT_EQ(orderParts(needs, 6).parts, found.parts);
    }
}

TEST(PartOrders, LeaveOutWhatNeedsMoreToolsThanThereArePlaces) {
    const PartOrder found = orderParts({{"A"}, {"A", "B", "C"}, {"B"}, {}}, 2);
    EXPECT_EQ(found.too_many, (std::vector<std::size_t>{1}));
    EXPECT_EQ(found.parts.size(), 3U);
    EXPECT_EQ(found.loads, 2);
}

TEST(PartOrders, OfNoPartsAreEmpty) {
    EXPECT_TRUE(orderParts({}, 4).parts.empty());
    EXPECT_EQ(orderParts({{}}, 4).loads, 0);
}

}  // namespace
}  // namespace stepmill
