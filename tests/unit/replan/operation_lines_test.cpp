#include "replan/operation_lines.h"

#include <gtest/gtest.h>

#include "stepmill/replan/plan_change.h"

namespace stepmill::replan {
namespace {

using Lines = std::vector<std::string>;

TEST(LinesKept, CountsBothEndsAndNoLineTwice) {
    EXPECT_EQ(linesKept({"a", "b", "c", "d"}, {"a", "x", "y", "d"}), 2);
    EXPECT_EQ(linesKept({"a", "b"}, {"a", "b"}), 2);
    EXPECT_EQ(linesKept({"a", "a", "a"}, {"a", "a"}), 2);
    EXPECT_EQ(linesKept({"a"}, {}), 0);
}

TEST(OperationLines, LeavesBlockNumbersAsideAndPartsAtComments) {
    PlanFiles files;
    files.programs["S1"] = {{"S1.ngc",
                             "G21 G17 G90 G94 G54\n"
                             "(S1.O1 feature S1.F1 T1 rough)\n"
                             "N1 T1 M6\n"
                             "N2 G0 G43 H1 Z5.\n"
                             "N3 G0 X1. Y1.\n"
                             "(S1.O2 feature S1.F1 T1 rough)\n"
                             "N30 G0 X2.\n"
                             "N31 \n"
                             "M2\n",
                             {}}};
    RecordedSetup setup;
    setup.id = "S1";
    setup.operation_ids = {"S1.O1", "S1.O2"};
    const LinesById lines = operationLines(files, setup);
    EXPECT_EQ(lines.at("S1.O1"),
              (Lines{"(S1.O1 feature S1.F1 T1 rough)", "T1 M6", "G0 G43 H1 Z5.", "G0 X1. Y1."}));
    EXPECT_EQ(lines.at("S1.O2"), (Lines{"(S1.O2 feature S1.F1 T1 rough)", "G0 X2.", "", "M2"}));
}

TEST(OperationLines, LeaveOutWhereToolsAreChanged) {
    PlanFiles files;
    files.programs["S1"] = {{"S1.ngc",
                             "G21 G17 G90 G94 G54\n"
                             "(S1.O1 feature S1.F1 T1 rough)\n"
                             "N1 T1 M6\n"
                             "G53 G0 Z0.\n"
                             "N2 G0 X1. Y1.\n"
                             "N3 G0 G43 H1 Z5.\n"
                             "(S1.O2 feature S1.F1 T2 rough)\n"
                             "T2 M6\n"
                             "G53 G0 Z0.\n"
                             "N4 G0 X1. Y1.\n"
                             "N5 G0 G43 H2 Z5.\n"
                             "N6 G0 X2. Y3.\n"
                             "(S1.O3 feature S1.F1 T3 rough)\n"
                             "T3 M6\n"
                             "G53 G0 Z0.\n"
                             "N7 G0 G43 H3 Z5.\n"
                             "N8 G0 X2. Y3.\n"
                             "M2\n",
                             {}}};
    RecordedSetup setup;
    setup.id = "S1";
    setup.operation_ids = {"S1.O1", "S1.O2", "S1.O3"};
    const LinesById lines = operationLines(files, setup);
    EXPECT_EQ(lines.at("S1.O1").at(3), "G0 X1. Y1.");
    EXPECT_EQ(lines.at("S1.O2"), (Lines{"(S1.O2 feature S1.F1 T2 rough)", "T2 M6", "G53 G0 Z0.",
                                        "G0 G43 H2 Z5.", "G0 X2. Y3."}));
    EXPECT_EQ(lines.at("S1.O3"), (Lines{"(S1.O3 feature S1.F1 T3 rough)", "T3 M6", "G53 G0 Z0.",
                                        "G0 G43 H3 Z5.", "G0 X2. Y3.", "M2"}));
}

TEST(OperationLines, AreNoneWhereNothingIsCutOrTheMachineIsTooSmall) {
    RecordedSetup setup;
    setup.id = "S1";
    EXPECT_TRUE(operationLines({}, setup).empty());
    setup.operation_ids = {"S1.O1"};
    setup.within_travel = false;
    EXPECT_TRUE(operationLines({}, setup).empty());
}

TEST(PlanChange, IsSameMachiningWhereAllProgramsAreKept) {
    PlanChange change;
    change.programs = {{"S1", Change::Kept, 10, 10, 8, true}, {"S2", Change::Kept, 10, 10, 8, false}};
    EXPECT_TRUE(change.sameMachining());
    change.programs[1].change = Change::Changed;
    EXPECT_FALSE(change.sameMachining());
}

}  // namespace
}  // namespace stepmill::replan
