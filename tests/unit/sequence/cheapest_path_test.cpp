#include "stepmill/sequence/tool_dag.h"

#include <gtest/gtest.h>

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
