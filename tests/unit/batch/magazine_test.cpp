#include "stepmill/batch/magazine.h"

#include <limits>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace stepmill {
namespace {

/// Of a set of tools: unserved tasks, and cost.
std::pair<int, double> worthOf(const std::set<std::string>& set, const std::vector<ToolTask>& tasks,
                               double load_cost) {
    int unserved = 0;
    double cost = load_cost * static_cast<double>(set.size());
    for (const ToolTask& task : tasks) {
        double best = std::numeric_limits<double>::infinity();
        for (const ToolWay& way : task.ways) {
            const bool fits = std::all_of(way.tools.begin(), way.tools.end(),
                                          [&](const std::string& tool) { return set.contains(tool); });
            if (fits) best = std::min(best, way.cost);
        }
        if (std::isinf(best))
            ++unserved;
        else
            cost += task.pieces * best;
    }
    return {unserved, cost};
}

/// By trying every set of the tools T0, T1, ...
std::pair<int, double> byEnumeration(int tools, const std::vector<ToolTask>& tasks,
                                     const MagazineTerms& terms) {
    std::pair<int, double> best{std::numeric_limits<int>::max(), 0};
    for (unsigned mask = 0; mask < (1U << static_cast<unsigned>(tools)); ++mask) {
        std::set<std::string> set;
        for (int tool = 0; tool < tools; ++tool)
            if ((mask >> static_cast<unsigned>(tool)) & 1U) set.insert("T" + std::to_string(tool));
        if (terms.places > 0 && static_cast<int>(set.size()) > terms.places) continue;
        best = std::min(best, worthOf(set, tasks, terms.load_cost));
    }
    return best;
}

std::vector<ToolTask> randomTasks(std::mt19937& dice, int tools) {
    std::uniform_int_distribution<int> tool(0, tools - 1);
    std::uniform_int_distribution<int> few(1, 3);
    std::uniform_real_distribution<double> cost(1, 100);
    std::vector<ToolTask> tasks(12);
    for (ToolTask& task : tasks) {
        task.pieces = few(dice);
        for (int way = few(dice) + 1; way > 0; --way) {
            std::set<std::string> set;
            for (int count = few(dice); count > 0; --count)
                set.insert("T" + std::to_string(tool(dice)));
            task.ways.push_back({{set.begin(), set.end()}, cost(dice)});
        }
    }
    return tasks;
}

TEST(Magazine, IsTheBestOfAllSetsThatFit) {
    constexpr int kTools = 9;
    for (unsigned seed = 0; seed < 60; ++seed) {
        std::mt19937 dice(seed);
        const std::vector<ToolTask> tasks = randomTasks(dice, kTools);
        MagazineTerms terms;
        terms.places = static_cast<int>(seed % 10);
        terms.load_cost = seed % 3 == 0 ? 0 : 25;
        const Magazine found = bestMagazine(tasks, terms);
        const auto [unserved, cost] = byEnumeration(kTools, tasks, terms);
        EXPECT_TRUE(found.proven) << seed;
        EXPECT_EQ(found.unserved, unserved) << seed;
        EXPECT_NEAR(found.cost, cost, 1e-9 * cost) << seed;
        const auto again = worthOf({found.tools.begin(), found.tools.end()}, tasks, terms.load_cost);
        EXPECT_EQ(again.first, found.unserved) << seed;
        EXPECT_NEAR(again.second, found.cost, 1e-9 * cost) << seed;
    }
}

TEST(Magazine, WithoutProofTheBoundHolds) {
    constexpr int kTools = 9;
    for (unsigned seed = 0; seed < 40; ++seed) {
        std::mt19937 dice(seed);
        const std::vector<ToolTask> tasks = randomTasks(dice, kTools);
        MagazineTerms terms;
        terms.places = 5;
        terms.load_cost = 25;
        terms.most_sets = 5;
        const Magazine found = bestMagazine(tasks, terms);
        const auto [unserved, cost] = byEnumeration(kTools, tasks, terms);
        EXPECT_GE(found.unserved, unserved);
        if (found.unserved == unserved) {
            EXPECT_LE(found.bound, cost + 1e-9) << seed;
            EXPECT_GE(found.cost, cost - 1e-9) << seed;
        }
        if (found.proven) {
            EXPECT_NEAR(found.cost, cost, 1e-9 * cost) << seed;
        }
    }
}

TEST(Magazine, TakesAToolOutThatIsNotWorthItsPlace) {
    const std::vector<ToolTask> tasks{{{{{"A"}, 10}, {{"B"}, 8}}, 1}, {{{{"A"}, 5}}, 1}};
    EXPECT_EQ(bestMagazine(tasks, {0, 1}).tools, (std::vector<std::string>{"A", "B"}));
    EXPECT_EQ(bestMagazine(tasks, {0, 3}).tools, (std::vector<std::string>{"A"}));
    EXPECT_EQ(bestMagazine(tasks, {1, 0}).tools, (std::vector<std::string>{"A"}));
    EXPECT_EQ(bestMagazine(tasks, {1, 0}).all_tools_cost, 13);
}

TEST(Magazine, TellsWhatEachToolIsWorth) {
    const std::vector<ToolTask> tasks{{{{{"A"}, 10}, {{"B"}, 8}}, 3}, {{{{"A"}, 5}}, 1}, {{{{"C"}, 1}}, 1}};
    const Magazine found = bestMagazine(tasks, {2, 0});
    ASSERT_EQ(found.tools, (std::vector<std::string>{"A", "C"}));
    ASSERT_EQ(found.values.size(), 3U);
    EXPECT_EQ(found.values[0].serves, 2) << "nothing else does the first two";
    EXPECT_EQ(found.values[0].saves, 0);
    EXPECT_FALSE(found.values[1].inside);
    EXPECT_EQ(found.values[1].serves, 0);
    EXPECT_EQ(found.values[1].saves, 6);
    EXPECT_EQ(found.values[2].serves, 1);
}

TEST(Magazine, NoTasksNeedNoTools) {
    const Magazine none = bestMagazine({}, {5, 10});
    EXPECT_TRUE(none.tools.empty());
    EXPECT_TRUE(none.proven);
    EXPECT_EQ(none.cost, 0);
}

}  // namespace
}  // namespace stepmill
