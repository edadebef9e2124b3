#include "stepmill/post/read_program.h"

#include <gtest/gtest.h>

#include "stepmill/core/error.h"
#include "unit/post/drilled_plan.h"

namespace stepmill::test {
namespace {

const std::string kBegin = "G21 G17 G40 G49 G80 G90 G94 G54\nT3 M6\nS8000 M3\nM8\n(S1.O1 feature S1.F1)\n";

ReadProgram read(const std::string& text, Dialect dialect = Dialect::LinuxCnc) {
    return readProgram(text, "S1.ngc", dialect);
}

/// The line the error names, 0 without an error.
int refusedLine(const std::string& text) {
    try {
        read(text);
        return 0;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::InvalidCatalog);
        const std::string subject = error.subject();
        EXPECT_EQ(subject.rfind("S1.ngc, line ", 0), 0U) << subject;
        return std::stoi(subject.substr(13));
    }
}

double lengthOf(const ReadOperation& operation) {
    double sum = 0;
    Vec3 from = operation.start;
    for (const ReadMove& read : operation.moves) {
        const Move& move = read.fed.move;
        const double flat = length(Vec2(from.head<2>()), {Vec2(move.to.head<2>()), move.arc});
        if (move.kind != MoveKind::Rapid) sum += std::hypot(flat, move.to.z() - from.z());
        from = move.to;
    }
    return sum;
}

class EveryDialect : public testing::TestWithParam<std::tuple<Dialect, bool>> {};

TEST_P(EveryDialect, ComesBackAsItWasPlanned) {
    const auto [dialect, inch] = GetParam();
    const Plan plan = drilledPlan();
    const Job job = jobOf(plan, plan.setups[0]);
    const std::vector<PostedProgram> posted = post(job, {dialect, inch});
    const ReadProgram back = readProgram(posted.front().text, posted.front().file, dialect);
    ASSERT_EQ(back.operations.size(), job.operations.size());
    for (std::size_t i = 0; i < job.operations.size(); ++i) {
        const JobOperation& planned = job.operations[i];
        const ReadOperation& operation = back.operations[i];
        EXPECT_EQ(operation.id, planned.id);
        EXPECT_EQ(operation.tool_number, planned.tool.number);
        EXPECT_NEAR(operation.speed_rpm, planned.speed_rpm, 1);
        EXPECT_EQ(operation.coolant, planned.coolant);
        EXPECT_NEAR(operation.dwell_s, planned.dwell_s, 1e-3);
        EXPECT_LT((operation.start - planned.start).norm(), 5e-4);
        EXPECT_LT((operation.moves.back().fed.move.to - planned.moves.back().move.to).norm(), 5e-4);
        if (planned.pattern == "drill") continue;
        EXPECT_NEAR(lengthOf(operation), plan.setups[0].operations[i].path.totals.cut_length_mm, 2e-3);
    }
}

INSTANTIATE_TEST_SUITE_P(Posts, EveryDialect,
                         testing::Combine(testing::Values(Dialect::LinuxCnc, Dialect::Fanuc, Dialect::Grbl),
                                          testing::Bool()),
                         [](const auto& parameter) {
                             return toString(std::get<0>(parameter.param)) +
                                    (std::get<1>(parameter.param) ? "Inch" : "Metric");
                         });

TEST(ReadProgram, ReadsPecksAsLinuxCncDrillsThem) {
    const ReadProgram program =
        read(kBegin + "G0 Z5\nG0 X20 Y20\nG98 G83 X20 Y20 Z-10 R1 Q4 F100\nG80\nM30\n");
    std::vector<double> heights;
    for (const ReadMove& move : program.operations.at(0).moves)
        heights.push_back(move.fed.move.to.z());
    EXPECT_EQ(heights, (std::vector<double>{1, -3, 1, -2.746, -7, 1, -6.746, -10, 5}));
}

TEST(ReadProgram, TellsPlungeRampAndLevelFeedApart) {
    const ReadProgram program =
        read(kBegin + "G0 Z5\nG0 X0 Y0\nG1 Z-1 F100\nG1 X5 Z-2\nG3 X5 Y5 I0 J2.5\nM30\n");
    const auto& moves = program.operations.at(0).moves;
    ASSERT_EQ(moves.size(), 3U);
    EXPECT_EQ(moves[0].fed.move.kind, MoveKind::Plunge);
    EXPECT_EQ(moves[1].fed.move.kind, MoveKind::Ramp);
    EXPECT_EQ(moves[2].fed.move.kind, MoveKind::Feed);
    EXPECT_EQ(moves[2].line, 10);
    EXPECT_TRUE(moves[2].fed.move.arc.has_value());
}

TEST(ReadProgram, RefusesWhatItCannotKnowNamingTheLine) {
    EXPECT_EQ(refusedLine(kBegin + "G0 X0 Y0\nM30\n"), 6) << "height unknown";
    EXPECT_EQ(refusedLine(kBegin + "G1 Z-1 F100\nM30\n"), 6) << "a feed from nowhere";
    EXPECT_EQ(refusedLine(kBegin + "G0 Z5\nG0 X0 Y0\nG1 X5\nM30\n"), 8) << "no F";
    EXPECT_EQ(refusedLine(kBegin + "G0 Z5\nG0 X0 Y0\nM5\nG1 X5 F100\nM30\n"), 9) << "spindle off";
    EXPECT_EQ(refusedLine(kBegin + "G0 Z5\nG0 X0 Y0\nG2 X5 Y0 I1 J0 F100\nM30\n"), 8) << "no circle";
    EXPECT_EQ(refusedLine(kBegin + "G0 Z5\nG55\nM30\n"), 7) << "another work offset";
    EXPECT_EQ(refusedLine(kBegin + "G0 Z5\nG0 X1.2.3\nM30\n"), 7) << "a bad number";
    EXPECT_EQ(refusedLine(kBegin + "G0 Z5\n"), 6) << "no end";
    EXPECT_EQ(refusedLine("G21\nG0 Z5\nM30\n"), 2) << "no operation";
}

TEST(Post, WritesAProgramForEveryVisitOfATool) {
    const Plan plan = drilledPlan();
    const std::vector<PostedProgram> posted = post(jobOf(plan, plan.setups[0]), {Dialect::Grbl, false, true});
    ASSERT_EQ(posted.size(), 3U);
    EXPECT_EQ(posted[0].file, "S1-1-T3.gcode");
    EXPECT_EQ(posted[2].file, "S1-3-T5.gcode");
    for (const PostedProgram& program : posted)
        EXPECT_EQ(program.text.find("M0\n"), std::string::npos) << "one tool, no stop";
}

}  // namespace
}  // namespace stepmill::test
