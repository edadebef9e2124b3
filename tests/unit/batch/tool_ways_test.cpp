#include "batch/tool_ways.h"

#include <gtest/gtest.h>

namespace stepmill {
namespace {

using Tools = std::vector<std::string>;

DagEdge edge(const std::string& from, const std::string& to, double time_s, double cost = 0) {
    DagEdge edge;
    edge.from.tool = from;
    edge.to.tool = to;
    edge.time_s = time_s;
    edge.cost = cost;
    return edge;
}

TEST(ToolWays, AreThoseThroughTheDagTheCheapestFirst) {
    const auto ways = batch::waysThrough(
        {edge("", "A", 10), edge("A", "B", 5), edge("B", "", 0), edge("", "B", 30)}, Objective::Time);
    ASSERT_EQ(ways.size(), 2U);
    EXPECT_EQ(ways[0].tools, (Tools{"A", "B"}));
    EXPECT_EQ(ways[0].cost, 15);
    EXPECT_EQ(ways[1].tools, (Tools{"B"}));
    EXPECT_EQ(ways[1].cost, 30);
}

TEST(ToolWays, ThatTakeAllToolsOfACheaperOneAreLeftOut) {
    const auto ways = batch::waysThrough(
        {edge("", "A", 10), edge("A", "B", 5), edge("B", "", 0), edge("", "B", 12)}, Objective::Time);
    ASSERT_EQ(ways.size(), 1U);
    EXPECT_EQ(ways[0].tools, (Tools{"B"}));
}

TEST(ToolWays, HoldSurrogatesAndWeighByTheObjective) {
    DagEdge with = edge("", "A", 10, 3);
    with.surrogates.push_back({"S", 1, {}});
    const auto ways = batch::waysThrough({with, edge("A", "", 0)}, Objective::Cost);
    ASSERT_EQ(ways.size(), 1U);
    EXPECT_EQ(ways[0].tools, (Tools{"A", "S"}));
    EXPECT_EQ(ways[0].cost, 3);
}

TEST(ToolWays, AreNoneWhereNoToolCanMachineAnything) {
    EXPECT_TRUE(batch::waysThrough({}, Objective::Time).empty());
    EXPECT_TRUE(batch::waysThrough({edge("", "A", 1)}, Objective::Time).empty()) << "it ends nowhere";
}

}  // namespace
}  // namespace stepmill
