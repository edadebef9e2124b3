#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/catalog/spindle.h"
#include "unit/catalog/catalog_test_files.h"

namespace stepmill {
namespace {

using nlohmann::json;
using test::sample;
using test::thrownBy;

std::string messageOf(const json& machine) {
    return thrownBy([&] { machineFromText(machine.dump(), "mill.json"); }).what();
}

json goodMachine() {
    return json::parse(readFile(sample("machine_vmc.json")));
}

TEST(InSpindle, PutsTheNoseOnTheTopOfTheHolder) {
    ToolAssembly tool;
    tool.stick_out_mm = 30;
    tool.holder = {{28, 30, 50}, {32, 50, 100}};
    Machine machine;
    machine.spindle_nose = {{90, 0, 25}, {150, 25, 110}};
    const ToolAssembly mounted = inSpindle(tool, machine);
    ASSERT_EQ(mounted.holder.size(), 4U);
    EXPECT_DOUBLE_EQ(mounted.holder[2].diameter_mm, 90);
    EXPECT_DOUBLE_EQ(mounted.holder[2].bottom_mm, 100);
    EXPECT_DOUBLE_EQ(mounted.holder[3].top_mm, 210);
    EXPECT_DOUBLE_EQ(setTo(mounted, 40).holder[2].bottom_mm, 110) << "it goes up with the holder";
}

TEST(InSpindle, WithoutANoseOrAHolder) {
    ToolAssembly tool;
    tool.stick_out_mm = 30;
    EXPECT_TRUE(inSpindle(tool, Machine()).holder.empty());
    Machine machine;
    machine.spindle_nose = {{90, 0, 25}};
    EXPECT_DOUBLE_EQ(inSpindle(tool, machine).holder.front().bottom_mm, 30);
}

TEST(InSpindle, KeepsHolderAndNoseOffByTheMachinesClearance) {
    ToolAssembly tool;
    tool.stick_out_mm = 30;
    tool.holder = {{28, 30, 50}};
    Machine machine;
    machine.spindle_nose = {{90, 0, 25}};
    machine.holder_clearance_mm = 1.5;
    const ToolAssembly mounted = inSpindle(tool, machine);
    EXPECT_DOUBLE_EQ(mounted.holder[0].diameter_mm, 28) << "the holder itself stays as it is";
    const std::vector<HolderCylinder> kept = keptOffHolder(mounted);
    ASSERT_EQ(kept.size(), 2U);
    EXPECT_DOUBLE_EQ(kept[0].diameter_mm, 31);
    EXPECT_DOUBLE_EQ(kept[0].bottom_mm, 28.5);
    EXPECT_DOUBLE_EQ(kept[1].diameter_mm, 93);
    EXPECT_DOUBLE_EQ(kept[1].bottom_mm, 48.5);
    EXPECT_EQ(clearanceWords(mounted), ", with 1.5 mm of clearance");
    EXPECT_EQ(clearanceWords(tool), "");
}

TEST(ReadMachine, GivesTheSpindle) {
    const Machine machine = readMachine(sample("machine_vmc.json"));
    ASSERT_EQ(machine.spindle_nose.size(), 3U);
    EXPECT_DOUBLE_EQ(machine.spindle_nose[0].bottom_mm, 0);
    EXPECT_GT(machine.gauge_over_table_mm[1], machine.gauge_over_table_mm[0]);
}

TEST(ReadMachine, SaysThatNoSpindleIsGiven) {
    json machine = goodMachine();
    machine.erase("spindle_nose");
    const Machine read = machineFromText(machine.dump(), "mill.json");
    ASSERT_EQ(read.by_default.size(), 1U);
    EXPECT_NE(read.by_default.front().find("spindle_nose"), std::string::npos);
}

TEST(MachineErrors, TellASpindleThatIsUpsideDown) {
    json machine = goodMachine();
    machine["spindle_nose"][1]["top_mm"] = 20;
    EXPECT_EQ(messageOf(machine),
              "mill.json#/spindle_nose/1/top_mm: expected more than the bottom, 25, found 20");
    machine = goodMachine();
    machine["spindle_nose"][1]["bottom_mm"] = 10;
    EXPECT_EQ(
        messageOf(machine),
        "mill.json#/spindle_nose/1/bottom_mm: expected at least the top of the cylinder below, 25, found "
        "10");
}

TEST(MachineErrors, TellATableThatTheSpindleIsBelow) {
    json machine = goodMachine();
    machine["gauge_over_table_mm"] = {600, 100};
    EXPECT_EQ(messageOf(machine),
              "mill.json#/gauge_over_table_mm/1: expected more than the lowest, 600, found 100");
}

}  // namespace
}  // namespace stepmill
