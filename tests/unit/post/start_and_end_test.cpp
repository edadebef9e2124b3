// How programs start, change tools and end, in every dialect.

#include <algorithm>
#include <sstream>

#include <gtest/gtest.h>

#include "stepmill/post/read_program.h"
#include "support/sample_plan.h"
#include "support/second_reader.h"

namespace stepmill::test {
namespace {

using Lines = std::vector<std::string>;

std::string posted(const PostOptions& options, const Plan& plan = samplePlan()) {
    return post(jobOf(plan, plan.setups[0]), options).front().text;
}

Lines linesOf(const std::string& text) {
    Lines lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

/// The lines after an operation's comment up to its first cut, without numbers of blocks and comments.
Lines startOf(const std::string& text, const std::string& id) {
    Lines start;
    bool inside = false;
    for (std::string line : linesOf(text)) {
        if (line.starts_with("(" + id + " ")) {
            inside = true;
        } else if (inside && line.find("G1 ") != std::string::npos) {
            break;
        } else if (inside && line[0] != '(') {
            if (line[0] == 'N') line = line.substr(line.find(' ') + 1);
            start.push_back(line);
        }
    }
    return start;
}

/// The last lines from the end of the last cut on.
Lines endOf(const std::string& text) {
    const Lines lines = linesOf(text);
    const auto m9 = std::find(lines.rbegin(), lines.rend(), "M9").base() - 1;
    return {m9, lines.end()};
}

TEST(StartOfOperation, ChangesToolsAtHomeAndComesDownLastOnLinuxCnc) {
    const std::string text = posted({});
    EXPECT_EQ(startOf(text, "S1.O1"),
              (Lines{"M5", "M9", "G53 G0 Z0.", "T3 M6", "G53 G0 Z0.", "G17 G40 G80 G90 G94 G54", "G64 P0.01",
                     "S8000 M3", "G0 X37.7778 Y20.1235", "G0 G43 H3 Z5.0000", "M8", "G0 Z1.0000"}));
    EXPECT_EQ(
        startOf(text, "S1.O3"),
        (Lines{"M5", "M9", "G53 G0 Z0.", "T12 M6", "G53 G0 Z0.", "G17 G40 G80 G90 G94 G54", "G64 P0.01",
               "S8000 M3", "G0 X24.0000 Y14.0000", "G0 G43 H12 Z5.0000", "M8", "G0 X70.0000 Y40.0000"}));
    EXPECT_EQ(endOf(text), (Lines{"M9", "M5", "G53 G0 Z0.", "M30"}));
}

TEST(StartOfOperation, ChangesToolsAtHomeAndComesDownLastOnFanuc) {
    const std::string text = posted({.dialect = Dialect::Fanuc});
    EXPECT_EQ(startOf(text, "S1.O1"), (Lines{"M5", "M9", "G91 G28 Z0.", "G90", "T3 M6", "G91 G28 Z0.", "G90",
                                             "G17 G40 G80 G90 G94 G54", "S8000 M3", "G0 X37.7778 Y20.1235",
                                             "G0 G43 H3 Z5.0000", "M8", "G0 Z1.0000"}));
    EXPECT_EQ(endOf(text), (Lines{"M9", "M5", "G91 G28 Z0.", "G90", "M30", "%"}));
}

TEST(StartOfOperation, StopsAtHomeForTheOperatorToChangeToolsOnGrbl) {
    const std::string text = posted({.dialect = Dialect::Grbl});
    EXPECT_EQ(
        startOf(text, "S1.O3"),
        (Lines{"M5", "M9", "G91 G28 Z0.", "G90", "T12", "M0", "G91 G28 Z0.", "G90", "G17 G40 G80 G90 G94 G54",
               "G61", "S8000 M3", "G0 X24.0000 Y14.0000", "G0 Z5.0000", "M8", "G0 X70.0000 Y40.0000"}));
    EXPECT_EQ(endOf(text), (Lines{"M9", "M5", "G91 G28 Z0.", "G90", "M30"}));
}

TEST(StartOfOperation, SaysAllModesAgainAndRisesFirstWhereTheToolStays) {
    EXPECT_EQ(startOf(posted({}), "S1.O2"),
              (Lines{"G17 G40 G80 G90 G94 G54", "G64 P0.01", "S8000 M3", "G0 G43 H3 Z5.0000",
                     "G0 X60.3333 Y21.1000", "M8", "G0 X10.0000 Y10.0000"}));
}

TEST(StartOfOperation, RisesFirstOnAMachineWithoutAHome) {
    Plan plan = samplePlan();
    plan.machine.home_by = HomeBy::Nothing;
    const std::string text = posted({.dialect = Dialect::Grbl}, plan);
    EXPECT_EQ(startOf(text, "S1.O1"), (Lines{"M5", "M9", "T3", "G17 G40 G80 G90 G94 G54", "G61", "S8000 M3",
                                             "G0 Z5.0000", "G0 X37.7778 Y20.1235", "M8", "G0 Z1.0000"}));
    EXPECT_EQ(endOf(text), (Lines{"M9", "M5", "M30"}));
}

TEST(StartOfOperation, IsListedByItsBlockInTheHeader) {
    const std::string text = posted({});
    EXPECT_NE(text.find("(From N1 S1.O1)\n(From N14 S1.O2)\n(From N23 S1.O3)\n"), std::string::npos) << text;
    EXPECT_NE(text.find("\nN14 G17 G40"), std::string::npos) << text;
}

TEST(StartOfOperation, StopsOnAskingAtHomeBeforeEveryOperationButTheFirst) {
    const std::string text = posted({.optional_stops = true});
    EXPECT_EQ(startOf(text, "S1.O1"), startOf(posted({}), "S1.O1"));
    EXPECT_EQ(startOf(text, "S1.O2"),
              (Lines{"M5", "M9", "G53 G0 Z0.", "M1", "G53 G0 Z0.", "G17 G40 G80 G90 G94 G54", "G64 P0.01",
                     "S8000 M3", "G0 X60.3333 Y21.1000", "G0 G43 H3 Z5.0000", "M8", "G0 X10.0000 Y10.0000"}));
    EXPECT_EQ(startOf(text, "S1.O3")[3], "M1");
}

TEST(StartOfOperation, CutsCornersShortByNoMoreThanWhatStays) {
    Plan plan = samplePlan();
    plan.machine.junction_deviation_mm = 0.3;
    auto& operations = plan.setups[0].operations;
    operations[0].leaves.walls_mm = 0.2;
    operations[1].leaves.walls_mm = 0.03;
    const std::string text = posted({}, plan);
    EXPECT_EQ(startOf(text, "S1.O1")[6], "G64 P0.05");
    EXPECT_EQ(startOf(text, "S1.O2")[1], "G64 P0.03");
    EXPECT_EQ(startOf(text, "S1.O3")[6], "G64 P0.02") << "the part itself";
    EXPECT_EQ(startOf(posted({.inch = true}, plan), "S1.O1")[6], "G64 P0.00196") << "rounded down";
}

TEST(EndOfProgram, BringsTheTableToTheOperator) {
    Plan plan = samplePlan();
    plan.machine.part_change_mm = {{-300, 5.5}};
    const Lines end{"M9", "M5", "G53 G0 Z0.", "G53 G0 X-300.0000 Y5.5000", "M30"};
    EXPECT_EQ(endOf(posted({}, plan)), end);
    plan.machine.home_by = HomeBy::Nothing;
    EXPECT_EQ(endOf(posted({}, plan)), (Lines{"M9", "M5", "M30"})) << "not across from over the part";
}

/// Runs the program where home lies 254 mm over the work offset's zero and T3 and T12 are 50.8 and 25.4 mm
/// long.
SecondReader onLinuxCnc(const std::string& text) {
    return {text, "T3 P3 Z2 D0.4 ;EM10\nT12 P12 Z1 D0.2 ;EM6\n", "5220 1\n5223 -10\n"};
}

TEST(SecondReader, GoesAcrossAtHomeAndDownWithTheToolsLength) {
    STEPMILL_NEEDS_SECOND_READER();
    constexpr double kHomeMm = 254;
    const SecondReader reader = onLinuxCnc(posted({.optional_stops = true}));
    ASSERT_EQ(reader.exit_code, 0) << reader.refusal;
    using Kind = CanonEvent::Kind;
    double machine_z = -kHomeMm;  // the spindle is left at the work offset's zero
    std::array<double, 2> over{};
    int changes = 0;
    int descents = 0;
    for (const CanonEvent& event : canonEvents(reader.output)) {
        if (event.kind == Kind::ToolChange || event.kind == Kind::End) {
            EXPECT_NEAR(machine_z, 0, 1e-3) << "home";
            ++changes;
        }
        if (event.kind != Kind::Rapid && event.kind != Kind::Feed && event.kind != Kind::Arc) continue;
        const double z = event.to[2] + event.length_offset - kHomeMm;
        const std::array<double, 2> to{event.to[0], event.to[1]};
        if (std::abs(machine_z) < 1e-3 && z < machine_z - 1e-3) {
            ++descents;
            EXPECT_EQ(to, over) << "straight down from home";
            EXPECT_NEAR(event.length_offset, event.tool == 3 ? 50.8 : 25.4, 1e-3);
            EXPECT_EQ(event.spin, 1) << "turns before it comes down";
        }
        machine_z = z;
        over = to;
    }
    EXPECT_EQ(changes, 3);
    EXPECT_EQ(descents, 3);
}

TEST(SecondReader, RunsEveryOperationFromItsFirstBlock) {
    STEPMILL_NEEDS_SECOND_READER();
    const std::string text = posted({});
    const auto eventsOf = [](const std::string& program) {
        std::vector<CanonEvent> events = canonEvents(onLinuxCnc(program).output);
        std::erase_if(events,
                      [](const CanonEvent& e) { return e.comment.find("S1.O2") == std::string::npos; });
        return events;
    };
    // The tool is in the spindle, as the operator has put it there; nothing else is said before.
    const std::string from = "G21\nT3 M6\n" + text.substr(text.find("(S1.O2 "));
    const std::vector<CanonEvent> whole = eventsOf(text);
    const std::vector<CanonEvent> part = eventsOf(from);
    ASSERT_GE(whole.size(), 5U);
    // Alone it has a way to its first place, which the whole program stands at already.
    ASSERT_GE(part.size(), whole.size());
    const std::size_t more = part.size() - whole.size();
    EXPECT_LE(more, 2U);
    for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_EQ(part[i + more].to, whole[i].to);
        EXPECT_EQ(part[i + more].feed_mm_per_min, whole[i].feed_mm_per_min);
        EXPECT_EQ(part[i + more].path_control, whole[i].path_control);
        EXPECT_EQ(part[i + more].speed_rpm, whole[i].speed_rpm);
        EXPECT_EQ(part[i + more].length_offset, whole[i].length_offset);
    }
}

}  // namespace
}  // namespace stepmill::test
