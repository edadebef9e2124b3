#include "stepmill/sequence/tool_dag.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "stepmill/core/error.h"

namespace stepmill {
namespace {

using Costs = std::map<std::pair<int, int>, double>;

std::function<double(int, int)> edgesOf(const Costs& costs) {
    return [&costs](int m, int n) {
        const auto found = costs.find({m, n});
        return found == costs.end() ? kNoEdge : found->second;
    };
}

TEST(CheapestPath, IsEmptyWithoutTools) {
    const CheapestPath path = cheapestPath(0, [](int, int) { return 1.0; }, {});
    EXPECT_TRUE(path.tools.empty());
    EXPECT_EQ(path.cost, kNoEdge);
}

TEST(CheapestPath, IsEmptyWhenNoToolFinishes) {
    const CheapestPath path = cheapestPath(2, [](int, int) { return 1.0; }, {false, false});
    EXPECT_TRUE(path.tools.empty());
    EXPECT_EQ(path.cost, kNoEdge);
}

TEST(CheapestPath, TakesTheDetourThatPays) {
    const Costs costs{{{kSource, 0}, 10}, {{kSource, 1}, 60}, {{0, 1}, 30}};
    const CheapestPath path = cheapestPath(2, edgesOf(costs), {false, true});
    EXPECT_EQ(path.tools, (std::vector<int>{0, 1}));
    EXPECT_EQ(path.cost, 40);
}

// [DSouza2006, Results]: eight tools make 255 sequences. Each is the cheapest where its edges alone cost
// nothing, and all are weighed by 8 x 9 / 2 edges.
TEST(CheapestPath, OfEightToolsIsAnyOf255SequencesOver36Edges) {
    constexpr int kTools = 8;
    std::set<std::vector<int>> found;
    for (unsigned subset = 1; subset < (1U << kTools); ++subset) {
        Costs free;
        std::vector<int> sequence;
        for (int k = 0; k < kTools; ++k) {
            if ((subset >> k & 1U) == 0) continue;
            free[{sequence.empty() ? kSource : sequence.back(), k}] = 0;
            sequence.push_back(k);
        }
        std::vector<bool> ends(kTools, false);
        ends[sequence.back()] = true;
        int asked = 0;
        const CheapestPath path = cheapestPath(
            kTools,
            [&](int m, int n) {
                ++asked;
                return free.count({m, n}) > 0 ? 0.0 : 1.0;
            },
            ends);
        EXPECT_EQ(path.tools, sequence);
        EXPECT_EQ(asked, 36);
        found.insert(path.tools);
    }
    EXPECT_EQ(found.size(), 255U);
}

TEST(CheapestPath, MayEndBeforeTheLastTool) {
    const Costs costs{{{kSource, 0}, 50}, {{kSource, 1}, 20}, {{kSource, 2}, 25}, {{1, 2}, 1}};
    const CheapestPath path = cheapestPath(3, edgesOf(costs), {false, true, true});
    EXPECT_EQ(path.tools, std::vector<int>{1});
    EXPECT_EQ(path.cost, 20);
}

TEST(CheapestPath, SkipsMissingEdges) {
    const Costs costs{{{kSource, 0}, 1}, {{0, 1}, 1}, {{1, 2}, 5}};
    const CheapestPath path = cheapestPath(3, edgesOf(costs), {false, false, true});
    EXPECT_EQ(path.tools, (std::vector<int>{0, 1, 2}));
    EXPECT_EQ(path.cost, 7);
}

TEST(CheapestPath, PrefersFewerToolsAtEqualCost) {
    const Costs costs{{{kSource, 0}, 10}, {{kSource, 1}, 40}, {{0, 1}, 30}};
    EXPECT_EQ(cheapestPath(2, edgesOf(costs), {false, true}).tools, std::vector<int>{1});
}

TEST(CheapestPath, PrefersLargerFirstToolsAtEqualCostAndCount) {
    const Costs costs{{{kSource, 0}, 10}, {{kSource, 1}, 10}, {{0, 2}, 5}, {{1, 2}, 5}};
    EXPECT_EQ(cheapestPath(3, edgesOf(costs), {false, false, true}).tools, (std::vector<int>{0, 2}));
}

TEST(CheapestPath, WantsOneEndMarkPerTool) {
    EXPECT_THROW(cheapestPath(2, [](int, int) { return 1.0; }, {true}), Error);
}

}  // namespace
}  // namespace stepmill
