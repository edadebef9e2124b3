#include <gtest/gtest.h>

#include "sequence/dag/candidate.h"
#include "stepmill/sequence/machine_limits.h"
#include "stepmill/sequence/sequence.h"
#include "stepmill/toolpath/path_frame.h"

namespace stepmill {
namespace {

Machine machineWithRates() {
    Machine machine;
    machine.tool_change_s = 5;
    machine.hourly_rate = 72;  // two cents a second
    return machine;
}

TEST(EdgeCost, TimeIsFeedsRapidsAndOneToolChange) {
    PathTotals totals;
    totals.feed_time_s = 90;
    totals.rapid_time_s = 5;
    EXPECT_DOUBLE_EQ(edgeCost(totals, ToolAssembly{}, machineWithRates()).time_s, 100);
}

TEST(EdgeCost, MoneyIsMachineTimeAndTheShareOfTheToolsLife) {
    PathTotals totals;
    totals.feed_time_s = 90;  // 1.5 minutes of a life of 30: a twentieth of the price
    totals.rapid_time_s = 5;
    ToolAssembly tool;
    tool.price = 40;
    tool.life_min = 30;
    EXPECT_DOUBLE_EQ(edgeCost(totals, tool, machineWithRates()).cost, 100 * 0.02 + 40 / 20.0);
}

TEST(EdgeCost, CountsNoWearWithoutAToolLife) {
    PathTotals totals;
    totals.feed_time_s = 95;
    ToolAssembly tool;
    tool.price = 40;
    EXPECT_DOUBLE_EQ(edgeCost(totals, tool, machineWithRates()).cost, 2);
}

TEST(DepthsOfCut, AreAsFewAsTheStepDownAllows) {
    EXPECT_EQ(toolpath::depthsFor(12, 0), 1);
    EXPECT_EQ(toolpath::depthsFor(12, 20), 1);
    EXPECT_EQ(toolpath::depthsFor(12, 4), 3);
    EXPECT_EQ(toolpath::depthsFor(12.1, 4), 4);
    EXPECT_EQ(toolpath::depthsFor(0.3, 0.1), 3);
}

TEST(LimitedBy, ASlowSpindleSlowsTheFeedsInProportion) {
    Machine machine;
    machine.max_speed_rpm = 6000;
    CuttingData cutting;
    cutting.speed_rpm = 12000;
    cutting.feed_mm_per_min = 1000;
    cutting.plunge_feed_mm_per_min = 300;
    const CuttingData limited = limitedBy(machine, cutting);
    EXPECT_EQ(limited.speed_rpm, 6000);
    EXPECT_EQ(limited.feed_mm_per_min, 500);
    EXPECT_EQ(limited.plunge_feed_mm_per_min, 150);
}

TEST(LimitedBy, NoFeedExceedsTheMachines) {
    Machine machine;
    machine.max_feed_mm_per_min = 800;
    CuttingData cutting;
    cutting.feed_mm_per_min = 1000;
    EXPECT_EQ(limitedBy(machine, cutting).feed_mm_per_min, 800);
    EXPECT_EQ(limitedBy(machine, cutting).plunge_feed_mm_per_min, 800);
}

TEST(ByFallingDiameter, PutsTheLongerReachLaterAtEqualDiameter) {
    ToolLibrary library;
    const auto add = [&](const char* id, double diameter, double stick_out) {
        ToolAssembly tool;
        tool.id = id;
        tool.diameter_mm = diameter;
        tool.stick_out_mm = stick_out;
        library.tools.push_back(tool);
    };
    add("6", 6, 20);
    add("10 long", 10, 50);
    add("10 short", 10, 30);
    add("20", 20, 40);
    std::vector<std::string> ids;
    for (const ToolAssembly* tool : byFallingDiameter(library))
        ids.push_back(tool->id);
    EXPECT_EQ(ids, (std::vector<std::string>{"20", "10 short", "10 long", "6"}));
}

}  // namespace
}  // namespace stepmill
