#include "plan/assignment/best_closure.h"

#include <gtest/gtest.h>

#include "support/dice.h"

namespace stepmill {
namespace {

double gainOf(const std::vector<Takeable>& all, const std::vector<bool>& taken) {
    double gain = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (taken[i]) gain += all[i].gain;
    return gain;
}

bool isClosed(const std::vector<Takeable>& all, const std::vector<bool>& taken) {
    for (std::size_t i = 0; i < all.size(); ++i)
        for (const std::size_t other : all[i].needs)
            if (taken[i] && !taken[other]) return false;
    return true;
}

double bestByEnumeration(const std::vector<Takeable>& all) {
    double best = 0;
    for (std::size_t set = 0; set < (std::size_t{1} << all.size()); ++set) {
        std::vector<bool> taken;
        for (std::size_t i = 0; i < all.size(); ++i)
            taken.push_back((set >> i & 1U) != 0);
        if (isClosed(all, taken)) best = std::max(best, gainOf(all, taken));
    }
    return best;
}

TEST(BestClosure, TakesNothingThatOnlyCosts) {
    EXPECT_EQ(bestClosure({{-1, {}}, {0, {}}}), (std::vector<bool>{false, false}));
    EXPECT_TRUE(bestClosure({}).empty());
}

TEST(BestClosure, PaysForWhatAGainNeeds) {
    // 5 for 2 pays, 3 for 4 does not.
    EXPECT_EQ(bestClosure({{5, {1}}, {-2, {}}, {3, {3}}, {-4, {}}}),
              (std::vector<bool>{true, true, false, false}));
}

TEST(BestClosure, SharesWhatTwoNeed) {
    EXPECT_EQ(bestClosure({{3, {2}}, {3, {2}}, {-5, {}}}), (std::vector<bool>{true, true, true}));
}

TEST(BestClosure, IsTheBestOfAllClosedSets) {
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        test::Dice dice(seed);
        std::vector<Takeable> all(1 + dice.below(10));
        for (std::size_t i = 0; i < all.size(); ++i) {
            all[i].gain = dice.between(-10, 10);
            for (std::size_t other = i + 1; other < all.size(); ++other)
                if (dice.chance(0.3)) all[i].needs.push_back(other);
        }
        const std::vector<bool> taken = bestClosure(all);
        EXPECT_TRUE(isClosed(all, taken)) << "seed " << seed;
        EXPECT_NEAR(gainOf(all, taken), bestByEnumeration(all), 1e-4) << "seed " << seed;
    }
}

}  // namespace
}  // namespace stepmill
