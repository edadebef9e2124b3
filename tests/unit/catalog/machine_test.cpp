#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/catalog/spindle.h"
#include "stepmill/core/file.h"
#include "unit/catalog/catalog_test_files.h"

namespace stepmill {
namespace {

using nlohmann::json;
using test::sample;
using test::thrownBy;

json goodMachine() {
    return json::parse(readFile(sample("machine_vmc.json")));
}

std::string messageOf(const json& machine) {
    const Error error = thrownBy([&] { machineFromText(machine.dump(), "mill.json"); });
    EXPECT_EQ(error.code(), ErrorCode::InvalidCatalog);
    return error.what();
}

TEST(ReadMachine, GivesEveryField) {
    const Machine machine = machineFromText(R"({
        "format": 1, "name": "Mill", "rapid_mm_per_min": 25000, "max_feed_mm_per_min": 10000, "max_speed_rpm": 8000,
        "tool_change_s": 4.5, "hourly_rate": 75.5, "currency": "CHF", "travel_mm": [500, 400, 300],
        "magazine_size": 20, "acceleration_mm_per_s2": 2500, "safe_height_mm": 3, "dialect": "linuxcnc"})",
                                            "mill.json");
    EXPECT_EQ(machine.name, "Mill");
    EXPECT_DOUBLE_EQ(machine.rapid_mm_per_min, 25000);
    EXPECT_DOUBLE_EQ(machine.max_feed_mm_per_min, 10000);
    EXPECT_DOUBLE_EQ(machine.max_speed_rpm, 8000);
    EXPECT_DOUBLE_EQ(machine.tool_change_s, 4.5);
    EXPECT_DOUBLE_EQ(machine.hourly_rate, 75.5);
    EXPECT_EQ(machine.currency, "CHF");
    EXPECT_EQ(machine.travel_mm, (std::array<double, 3>{500, 400, 300}));
    EXPECT_EQ(machine.magazine_size, 20);
    EXPECT_DOUBLE_EQ(machine.acceleration_mm_per_s2, 2500);
    EXPECT_DOUBLE_EQ(machine.safe_height_mm, 3);
    EXPECT_EQ(machine.dialect, "linuxcnc");
}

TEST(ReadMachine, DoesWithoutAcceleration) {
    json machine = goodMachine();
    machine.erase("acceleration_mm_per_s2");
    const Machine read = machineFromText(machine.dump(), "mill.json");
    EXPECT_EQ(read.acceleration_mm_per_s2, 0);
    EXPECT_DOUBLE_EQ(read.junction_deviation_mm, 0.01);
    machine["junction_deviation_mm"] = 0.05;
    EXPECT_DOUBLE_EQ(machineFromText(machine.dump(), "mill.json").junction_deviation_mm, 0.05);
}

TEST(ReadMachine, MaySayHowLongSettingUpTakes) {
    json machine = goodMachine();
    const Machine silent = machineFromText(machine.dump(), "mill.json");
    EXPECT_EQ(silent.setup_time_min, 20);
    EXPECT_EQ(silent.indexed_setup_time_min, 40);
    EXPECT_EQ(silent.load_time_s, 60);
    machine["setup_time_min"] = 12.5;
    machine["indexed_setup_time_min"] = 0;
    machine["load_time_s"] = 45;
    const Machine said = machineFromText(machine.dump(), "mill.json");
    EXPECT_EQ(said.setup_time_min, 12.5);
    EXPECT_EQ(said.indexed_setup_time_min, 0);
    EXPECT_EQ(said.load_time_s, 45);
    EXPECT_EQ(said.settingUpMin(false), 12.5);
    EXPECT_EQ(said.settingUpMin(true), 0);
    machine["setup_time_min"] = -1;
    EXPECT_THROW(machineFromText(machine.dump(), "mill.json"), Error);
}

TEST(ReadMachine, SaysWhichClearancesItTakesByDefault) {
    json machine = goodMachine();
    machine.erase("side_clearance_mm");
    machine.erase("holder_clearance_mm");
    machine["inside_clearance_mm"] = 0.25;
    const Machine read = machineFromText(machine.dump(), "mill.json");
    EXPECT_DOUBLE_EQ(read.side_clearance_mm, 2);
    EXPECT_DOUBLE_EQ(read.inside_clearance_mm, 0.25);
    EXPECT_DOUBLE_EQ(read.holder_clearance_mm, 1);
    EXPECT_EQ(read.by_default, (std::vector<std::string>{"side_clearance_mm 2", "holder_clearance_mm 1"}));
    EXPECT_TRUE(machineFromText(goodMachine().dump(), "mill.json").by_default.empty());
}

TEST(MachineErrors, TellAClearanceThatIsAbsurd) {
    json machine = goodMachine();
    machine["side_clearance_mm"] = -1;
    EXPECT_EQ(messageOf(machine), "mill.json#/side_clearance_mm: expected a number from 0 to 100, found -1");
}

TEST(MachineErrors, TellAJunctionDeviationOfNothing) {
    json machine = goodMachine();
    machine["junction_deviation_mm"] = 0;
    EXPECT_EQ(messageOf(machine),
              "mill.json#/junction_deviation_mm: expected a number from 0.0001 to 10, found 0");
}

TEST(ReadMachine, TakesTheSamples) {
    EXPECT_DOUBLE_EQ(readMachine(sample("machine_vmc.json")).rapid_mm_per_min, 30000);
    EXPECT_EQ(readMachine(sample("machine_knee_mill.json")).magazine_size, 1);
}

TEST(MachineErrors, TellAMissingField) {
    json machine = goodMachine();
    machine.erase("rapid_mm_per_min");
    EXPECT_EQ(messageOf(machine),
              "mill.json#: expected the field \"rapid_mm_per_min\", a number from 1 to 1000000, found none");
}

TEST(MachineErrors, TellAMisspeltFieldAndTheOneItStandsFor) {
    json machine = goodMachine();
    machine["safe_hieght_mm"] = 5;
    EXPECT_EQ(messageOf(machine),
              "mill.json#/safe_hieght_mm: unknown field; \"safe_height_mm\" is the nearest known one");
}

TEST(MachineErrors, TellATravelOfTwoAxes) {
    json machine = goodMachine();
    machine["travel_mm"] = {760, 410};
    EXPECT_EQ(messageOf(machine), "mill.json#/travel_mm: expected a list of 3 items, found a list of 2");
}

TEST(MachineErrors, TellANegativeTravel) {
    json machine = goodMachine();
    machine["travel_mm"] = {760, -410, 510};
    EXPECT_EQ(messageOf(machine), "mill.json#/travel_mm/1: expected a number from 1 to 100000, found -410");
}

TEST(MachineErrors, TellAnUnknownDialect) {
    json machine = goodMachine();
    machine["dialect"] = "klartext";
    EXPECT_EQ(messageOf(machine),
              "mill.json#/dialect: expected one of \"linuxcnc\", \"fanuc\", \"grbl\", found \"klartext\"");
}

TEST(MachineErrors, TellAFileThatIsNotThere) {
    EXPECT_EQ(thrownBy([] { readMachine(sample("no_such_machine.json")); }).code(),
              ErrorCode::FileUnreadable);
}

TEST(ReadMachine, GivesTheSpindlesCurve) {
    json machine = goodMachine();
    machine["spindle"] = {{"efficiency", 0.8},
                          {"curve",
                           {{{"speed_rpm", 1000}, {"power_kw", 4}, {"torque_nm", 38.2}},
                            {{"speed_rpm", 12000}, {"power_kw", 6}, {"torque_nm", 4.77}}}}};
    const Machine read = machineFromText(machine.dump(), "mill.json");
    ASSERT_EQ(read.spindle_curve.size(), 2U);
    EXPECT_DOUBLE_EQ(read.spindle_efficiency, 0.8);
    EXPECT_DOUBLE_EQ(read.spindle_curve[1].torque_nm, 4.77);
    // Constant torque below the first point, evenly growing power to the next, nothing beyond the last.
    EXPECT_DOUBLE_EQ(spindlePower(read, 500)->power_kw, 2);
    EXPECT_DOUBLE_EQ(spindlePower(read, 6500)->power_kw, 5);
    EXPECT_TRUE(spindlePower(read, 6500)->by_torque);
    EXPECT_DOUBLE_EQ(spindlePower(read, 12000)->power_kw, 6);
    EXPECT_FALSE(spindlePower(read, 12000)->by_torque);
    EXPECT_DOUBLE_EQ(spindlePower(read, 12001)->power_kw, 0);
}

TEST(ReadMachine, SaysThatNoPowerIsGiven) {
    json machine = goodMachine();
    machine.erase("spindle");
    const Machine read = machineFromText(machine.dump(), "mill.json");
    EXPECT_FALSE(spindlePower(read, 1000));
    ASSERT_EQ(read.by_default.size(), 1U);
    EXPECT_EQ(read.by_default.front().rfind("no spindle:", 0), 0U);
}

TEST(MachineErrors, TellPowerAndTorqueThatContradictEachOther) {
    json machine = goodMachine();
    machine["spindle"]["curve"][0]["power_kw"] = 15;
    EXPECT_EQ(messageOf(machine),
              "mill.json#/spindle/curve/0/power_kw: expected the power of 70 Nm at 1500 "
              "rpm, 11 kW, found 15");
}

TEST(MachineErrors, TellASpindleWithoutPower) {
    json machine = goodMachine();
    machine["spindle"]["curve"][0]["power_kw"] = 0;
    EXPECT_EQ(messageOf(machine),
              "mill.json#/spindle/curve/0/power_kw: expected a number from 0.001 to 1000, found 0");
    machine = goodMachine();
    machine["spindle"]["curve"][1].erase("speed_rpm");
    EXPECT_EQ(messageOf(machine),
              "mill.json#/spindle/curve/1: expected the field \"speed_rpm\", a number from 1 to 200000, "
              "found none");
    machine = goodMachine();
    machine["spindle"]["efficiency"] = 1.2;
    EXPECT_EQ(messageOf(machine),
              "mill.json#/spindle/efficiency: expected a number from 0.2 to 1, found 1.2");
}

TEST(MachineErrors, TellSpeedsOutOfOrderOrTooLow) {
    json machine = goodMachine();
    machine["spindle"]["curve"][1] = machine["spindle"]["curve"][0];
    EXPECT_EQ(messageOf(machine),
              "mill.json#/spindle/curve/1/speed_rpm: expected more than the speed before, 1500, found 1500");
    machine = goodMachine();
    machine["max_speed_rpm"] = 15000;
    EXPECT_EQ(messageOf(machine),
              "mill.json#/spindle/curve: expected points up to max_speed_rpm, 15000; the "
              "last is at 12000");
}

}  // namespace
}  // namespace stepmill
