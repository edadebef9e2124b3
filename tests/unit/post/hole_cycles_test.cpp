// Spots, broken chips, reamed and bored holes in every dialect: written, read back, run by LinuxCNC.

#include <gtest/gtest.h>

#include "stepmill/core/error.h"
#include "stepmill/post/read_program.h"
#include "support/hole_cycle_plan.h"
#include "support/second_reader.h"

namespace stepmill::test {
namespace {

std::string posted(Dialect dialect, bool inch = false) {
    const Plan plan = holeCyclePlan();
    return post(jobOf(plan, plan.setups[0]), {dialect, inch}).front().text;
}

bool holds(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

TEST(HoleCycles, HaveWordsOfTheirOwnWhereTheDialectHasThem) {
    for (const Dialect dialect : {Dialect::LinuxCnc, Dialect::Fanuc}) {
        const std::string text = posted(dialect);
        EXPECT_TRUE(holds(text, " G98 G81 X10.0000 Y40.1235 Z-3.0000 R1.0000 F")) << text;
        EXPECT_TRUE(holds(text, " G98 G73 X10.0000 Y40.1235 Z-30.0000 R1.0000 Q10.0000 F300.00\n")) << text;
        EXPECT_TRUE(holds(text, " G98 G85 X10.0000 Y40.1235 Z-28.0000 R1.0000 F200.00\n")) << text;
    }
    EXPECT_TRUE(
        holds(posted(Dialect::LinuxCnc), " G98 G89 X10.0000 Y40.1235 Z-25.0000 R1.0000 P0.250 F200.00\n"));
    EXPECT_TRUE(holds(posted(Dialect::Fanuc), " G98 G89 X10.0000 Y40.1235 Z-25.0000 R1.0000 P250 F200.00\n"));
}

TEST(HoleCycles, AreWrittenMoveByMoveWhereItHasNone) {
    const std::string text = posted(Dialect::Grbl);
    for (const char* cycle : {"G73", "G81", "G85", "G89"})
        EXPECT_FALSE(holds(text, cycle)) << cycle;
    EXPECT_TRUE(holds(text, "G4 P0.250\n"));
}

class HoleCycleDialects : public testing::TestWithParam<std::tuple<Dialect, bool>> {};

TEST_P(HoleCycleDialects, AreReadBackAsPlanned) {
    const auto [dialect, inch] = GetParam();
    const Plan plan = holeCyclePlan();
    const ReadProgram program = readProgram(posted(dialect, inch), "S1", dialect);
    const std::size_t first = plan.setups[0].operations.size() - 4;
    for (std::size_t i = first; i < first + 4; ++i) {
        const Operation& planned = plan.setups[0].operations[i];
        const ReadOperation& read = program.operations[i];
        ASSERT_EQ(read.id, planned.id);
        std::size_t next = 0;
        for (const Move& move : planned.path.moves) {
            // Controllers count pecks from the R plane: these end at other heights than the plan's.
            const bool in_hole = move.to.z() < 0 && move.to.z() > planned.z_floor_mm;
            if (in_hole) continue;
            while (next < read.moves.size() && (read.moves[next].fed.move.to - move.to).norm() > 1e-3)
                ++next;
            ASSERT_LT(next, read.moves.size()) << planned.id << " Z" << move.to.z();
            const bool feeds = read.moves[next].fed.move.kind != MoveKind::Rapid;
            EXPECT_EQ(feeds, move.kind != MoveKind::Rapid) << planned.id << " Z" << move.to.z();
        }
    }
    EXPECT_EQ(program.operations.back().dwells.size(), 2U);
}

INSTANTIATE_TEST_SUITE_P(Post, HoleCycleDialects,
                         testing::Combine(testing::Values(Dialect::LinuxCnc, Dialect::Fanuc, Dialect::Grbl),
                                          testing::Bool()));

TEST(HoleCycles, LinuxCncsInterpreterMakesTheSameMotions) {
    STEPMILL_NEEDS_SECOND_READER();
    const Plan plan = holeCyclePlan();
    const SecondReader reader(program(plan, plan.setups[0]), toolTable(jobOf(plan, plan.setups[0])));
    ASSERT_EQ(reader.exit_code, 0) << reader.refusal;
    const ReadProgram read = readProgram(program(plan, plan.setups[0]), "S1", Dialect::LinuxCnc);
    int feeds = 0;
    for (const ReadOperation& operation : read.operations)
        for (const ReadMove& move : operation.moves)
            if (move.fed.move.kind != MoveKind::Rapid && !move.fed.move.arc) ++feeds;
    EXPECT_EQ(reader.count("STRAIGHT_FEED("), feeds);
    EXPECT_EQ(reader.count("DWELL("), 2);
}

TEST(HoleCycles, WordsThatACycleNeedsAreAskedFor) {
    const auto refusal = [](const std::string& body) -> std::string {
        const std::string text =
            "G21 G17 G40 G49 G80 G90 G94 G54\nT7 M6\nS800 M3\nM8\nG43 H7\n"
            "(S1.O1 feature S1.F1)\nG0 Z5.\nG0 X10. Y10.\n" +
            body + "\nM30\n";
        try {
            readProgram(text, "S1", Dialect::LinuxCnc);
        } catch (const Error& error) {
            return error.what();
        }
        return {};
    };
    EXPECT_NE(refusal("G98 G73 Z-5. R1. F100").find("G73 without Q"), std::string::npos);
    EXPECT_NE(refusal("G98 G89 Z-5. R1. F100").find("G89 without P"), std::string::npos);
    EXPECT_EQ(refusal("G98 G85 Z-5. R1. F100\nG80"), "");
}

}  // namespace
}  // namespace stepmill::test
