#include "stepmill/post/read_program.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "stepmill/core/error.h"
#include "support/drilled_plan.h"

namespace stepmill::test {
namespace {

const std::string kBegin =
    "G21 G17 G40 G49 G80 G90 G94 G54\nT3 M6\nS8000 M3 M8 G43 H3\nG61\n(S1.O1 feature S1.F1)\n";

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

void expectState(const MachineState& state, const JobOperation& planned, bool has_length_offsets) {
    EXPECT_EQ(state.tool, planned.tool.number);
    EXPECT_EQ(state.length_offset, has_length_offsets ? planned.tool.number : kNoLengthOffset);
    EXPECT_EQ(state.work_offset, kPlannedWorkOffset);
    EXPECT_EQ(state.plane, Plane::XY);
    EXPECT_EQ(state.distance, DistanceMode::Absolute);
    EXPECT_EQ(state.feed_mode, FeedMode::PerMinute);
    EXPECT_TRUE(state.compensation_off);
    EXPECT_EQ(state.spin, Spin::Clockwise);
    EXPECT_NEAR(state.speed_rpm, planned.speed_rpm, 1);
    EXPECT_EQ(state.mist, planned.coolant == Coolant::Mist);
    EXPECT_EQ(state.flood, planned.coolant == Coolant::Flood);
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
        ASSERT_FALSE(operation.moves.empty());
        for (const ReadMove& move : operation.moves)
            expectState(back.states[move.state], planned, back.has_length_offsets);
        ASSERT_EQ(operation.dwells.size(),
                  planned.dwell_s > 0 ? static_cast<std::size_t>(std::max(1, planned.holes)) : 0U);
        if (planned.dwell_s > 0) {
            EXPECT_NEAR(operation.dwells.front().seconds, planned.dwell_s, 1e-3);
        }
        EXPECT_LT((operation.start - planned.start).norm(), 5e-4);
        EXPECT_LT((operation.moves.back().fed.move.to - planned.moves.back().move.to).norm(), 5e-4);
        // Cycles count their pecks from the clearance plane.
        if (planned.pattern.starts_with("drill")) continue;
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

TEST(Post, WritesEqualHolesAsOneCycle) {
    const Plan plan = drilledPlan();
    const std::string text = post(jobOf(plan, plan.setups[0]), {}).front().text;
    const std::size_t cycle = text.rfind("G82");
    ASSERT_NE(cycle, std::string::npos);
    const std::string block = text.substr(cycle, text.find("G80", cycle) - cycle);
    EXPECT_NE(block.find("X30.0000 Y10.0000 Z-10.0000 R"), std::string::npos) << block;
    EXPECT_NE(block.find(" X40.0000 Y10.7654\n"), std::string::npos) << block;
    EXPECT_NE(block.find(" X40.0000 Y20.0000\n"), std::string::npos) << block;
}

TEST(Post, ExpandsEveryHoleWhereThereAreNoCycles) {
    const Plan plan = drilledPlan();
    const Job job = jobOf(plan, plan.setups[0]);
    const std::vector<PostedProgram> posted = post(job, {Dialect::Grbl});
    const ReadProgram back = readProgram(posted.front().text, posted.front().file, Dialect::Grbl);
    const ReadOperation& group = back.operations.back();
    EXPECT_EQ(group.dwells.size(), 3U);
    for (const ReadDwell& dwell : group.dwells)
        EXPECT_NEAR(dwell.z_mm, -10, 1e-4);
}

TEST(ReadProgram, ReadsPecksAsLinuxCncDrillsThem) {
    const ReadProgram program =
        read(kBegin + "G0 Z5\nG0 X20 Y20\nG98 G83 X20 Y20 Z-10 R1 Q4 F100\nG80\nM30\n");
    std::vector<double> heights;
    for (const ReadMove& move : program.operations.at(0).moves)
        heights.push_back(move.fed.move.to.z());
    const std::vector<double> expected{1, -3, 1, -2.746, -7, 1, -6.746, -10, 5};
    ASSERT_EQ(heights.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_NEAR(heights[i], expected[i], kGridMm);
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
    EXPECT_EQ(refusedLine(kBegin + "G0 Z5\nG0 X0 Y0\nG2 X5 Y0 I1 J0 F100\nM30\n"), 8) << "no circle";
    EXPECT_EQ(refusedLine(kBegin + "G0 Z5\nG0 X1.2.3\nM30\n"), 7) << "a bad number";
    EXPECT_EQ(refusedLine(kBegin + "G0 Z5\n"), 6) << "no end";
    EXPECT_EQ(refusedLine("G21 G90\nT1 M6\nG0 Z5\nG0 X0 Y0\nG0 X5\nM30\n"), 5) << "no operation";
    EXPECT_EQ(refusedLine("G21\nG0 Z5\nM30\n"), 2) << "neither G90 nor G91";
}

/// The moves after an approach to X0 Y0 Z5; F is 100.
ReadOperation run(const std::string& blocks, Dialect dialect = Dialect::LinuxCnc) {
    return read(kBegin + "G0 Z5\nG0 X0 Y0\nF100\n" + blocks + "M30\n", dialect).operations.at(0);
}

/// Is the one block refused where it stands?
void expectRefused(const std::string& block) {
    EXPECT_EQ(refusedLine(kBegin + "G0 Z5\nG0 X0 Y0\nF100\n" + block + "\nG0 Z5\nM30\n"), 9) << block;
}

Vec3 endOf(const std::string& blocks) {
    const ReadOperation operation = run(blocks);
    return operation.moves.empty() ? operation.start : operation.moves.back().fed.move.to;
}

TEST(ReadProgram, RefusesWhatAControllerRefuses) {
    for (const char* block : {"G2 X2 R1 I1",
                              "G0 G1 X5",
                              "G1 X1e2",
                              "T5.7",
                              "G1 (X5",
                              "G1 X5 X6",
                              "G90 G91",
                              "M3 M5",
                              "G1 X",
                              "G1 X-",
                              "G1 X--5",
                              "X5 N7",
                              "G2 X2",
                              "G2 X2 R.9",
                              "G2 X0 Y0 R2",
                              "G2 X2 I1 P1.5",
                              "G2 X2 I1 P0",
                              "G80 X5",
                              "G4",
                              "G4 P-1",
                              "G28 G1 X5",
                              "G53 G1 Z0",
                              "G91 G53 G0 Z0",
                              "H5",
                              "P5",
                              "R5",
                              "Q5",
                              "I5",
                              "S-5",
                              "F-5",
                              "G83 X1 Z-1 R1",
                              "G81 X1 Z2 R1",
                              "G82 X1 Z-1 R1",
                              "G81 X1 Z-1",
                              "G54 G55",
                              "%",
                              "G1 X5 (a(b)) Y5",
                              "G1 X5) Y5",
                              "M5 M5",
                              "G1 X5 \x01",
                              "\xC3\x84",
                              "G93 G1 X5",
                              "G1.5 X5",
                              "M3.5",
                              "G200"})
        expectRefused(block);
    expectRefused("G1 X5 (" + std::string(250, 'a') + ")");
}

TEST(ReadProgram, RefusesWhatItDoesNotObey) {
    for (const char* block : {"#1=5",        "G1 X#1",           "G1 X[1+2]", "O100 SUB", "/G1 X5",
                              "G92 X0",      "G10 L2 P1 X0",     "G41 D1",    "G5 X5",    "A5",
                              "G43.1 Z5",    "G73 X1 Z-1 R1 Q1", "G38.2 X5",  "M19",      "M60",
                              "M98 P1",      "G96 S100",         "G7",        "L2",       "G52 X5",
                              "(ABORT, no)", "; py, print(1)",   "G53 G0 Z-5"})
        expectRefused(block);
}

TEST(ReadProgram, TakesHarmlessText) {
    const Vec3 end(5, 2.5, 1);
    for (const char* blocks :
         {"G1 X5 Y2.5 Z1\n", "g1x5y2.5z1\n", "G1 X+5 Y02.50 Z1.\n", "G01 X5. Y+2.5 Z 1 ; comment (\n",
          "N70 G1 (one) X5 (two) Y 2 . 5 Z1\n", "M1\nG64 P0.01\nG1 X5 Y2.5 Z1\n",
          "\n\n  \t\r\nG1 X5 Y2.5\r\nZ1\n", "G91\nG1 X5 Y2.5\nZ-4\nG90\n",
          "G20 G1\nX.19685039370 Y.09842519685 F2\nG21\nG94\nG1 Z1 F100\n", "G4 P1\nG1 X5 Y2.5 Z1\n",
          "(G0 Z-50)\n;G0 Z-50\nG1 X5 Y2.5 Z1\n", "G0 X9\nG1\nX5 Y2.5 Z1\n"})
        EXPECT_LT((endOf(blocks) - end).norm(), 1e-5) << blocks;
    EXPECT_EQ(read("\xEF\xBB\xBF" + kBegin + "M2").operations.size(), 1U)
        << "a byte order mark, no last line end";
    EXPECT_EQ(read("%\n" + kBegin + "%\n(whatever)").operations.size(), 1U);
    EXPECT_EQ(read("g21 g90\n(s1.o1 feature)\nm2\n").operations.at(0).id, "S1.O1");
}

TEST(ReadProgram, ReadsArcsByRadiusAndWithTurns) {
    const auto quarter = run("G3 X2 Y2 R2\n").moves;
    ASSERT_EQ(quarter.size(), 1U);
    EXPECT_LT((quarter.at(0).fed.move.arc.value().centre - Vec2(0, 2)).norm(), 1e-6);
    const auto large = run("G2 X2 Y2 R-2\n").moves;
    EXPECT_LT((large.at(0).fed.move.arc.value().centre - Vec2(0, 2)).norm(), 1e-6);
    const auto turns = run("G3 X4 Z0 I2 P3\n").moves;
    ASSERT_EQ(turns.size(), 3U);
    EXPECT_EQ(turns[0].fed.move.to.head<2>(), Vec2(0, 0)) << "a whole turn first";
    EXPECT_NEAR(turns[0].fed.move.to.z(), 5 - 5 * 2 / 5.0, 1e-6);
    EXPECT_EQ(turns[2].fed.move.to, Vec3(4, 0, 0));
}

TEST(ReadProgram, DrillsAgainWhereACycleIsInForce) {
    std::vector<Vec3> bottoms;
    for (const ReadMove& move : run("G98 G81 X1 Y1 Z-2 R1\nX3\nG80\nG0 X9\n").moves)
        if (move.fed.move.kind == MoveKind::Plunge) bottoms.push_back(move.fed.move.to);
    EXPECT_EQ(bottoms, (std::vector<Vec3>{{1, 1, -2}, {3, 1, -2}}));
}

TEST(ReadProgram, KnowsThePreparedToolFromTheOneInTheSpindle) {
    const ReadProgram program =
        read(kBegin + "G0 Z5\nG0 X0 Y0\nT7\nG1 X5 F100\nG0 Z9\nM6\nG43 H7\nS1 M3\nG0 Z9\nG0 X1 Y1\nM30\n");
    const ReadOperation& operation = program.operations.at(0);
    EXPECT_EQ(program.states[operation.moves.at(0).state].tool, 3);
    EXPECT_EQ(program.states[operation.moves.back().state].tool, 7);
    ASSERT_EQ(program.stops.size(), 3U) << "two changes and the end";
    EXPECT_EQ(program.stops[1].z_mm, 9);
    EXPECT_EQ(program.stops[1].line, 10);
}

TEST(ReadProgram, GoesHomeByTheIntermediatePoint) {
    const ReadProgram program = read(kBegin + "G0 Z5\nG0 X0 Y0\nG28 X3 Z-1\nG0 Z5\nG0 X0 Y0\nM30\n");
    EXPECT_EQ(program.operations.at(0).moves.at(0).fed.move.to, Vec3(3, 0, -1));
    const auto home = std::find_if(program.leaps.begin(), program.leaps.end(),
                                   [](const ReadLeap& leap) { return leap.line == 8; });
    ASSERT_NE(home, program.leaps.end());
    EXPECT_EQ(home->from_z_mm, -1);
    EXPECT_TRUE(home->across);
}

TEST(ReadProgram, StandsAtTheHighestPlaceForTheTopOfTheMachine) {
    const auto moves = run("G53 G0 Z0\nG0 X7\nG0 Z5\n").moves;
    ASSERT_GE(moves.size(), 1U);
    EXPECT_EQ(moves.back().fed.move.to, Vec3(7, 0, 5));
}

TEST(ReadProgram, ReadsEachControllersOwnWords) {
    const std::string fanuc =
        "%\nO0001\nG21 G17 G40 G49 G80 G90 G94 G54\n(S1.O1)\nT3 M6\nS1 M3\nG0 G43 H3 Z5.\nG0 X0. Y0.\n";
    EXPECT_NEAR(read(fanuc + "G4 P500\nM30\n%\n", Dialect::Fanuc).operations[0].dwells[0].seconds, 0.5, 1e-9);
    EXPECT_THROW(read(fanuc + "G0 X50\nM30\n%\n", Dialect::Fanuc), Error) << "50 mm or 0.05?";
    EXPECT_THROW(read(fanuc + "G0 X5. ; G0 Z-5.\nM30\n%\n", Dialect::Fanuc), Error) << "; ends a block";
    const std::string grbl = "G21 G17 G40 G49 G80 G90 G94 G54\nG61\n(S1.O1)\nT3\nS1 M3\nG0 Z5\nG0 X0 Y0\n";
    EXPECT_EQ(read(grbl + "M30\n", Dialect::Grbl).states.back().tool, 3);
    for (const char* block : {"M6", "G43 H3", "G81 X1 Z-1 R1 F1", "G64", "G98", "G59.1", "G2 X2 I1 P2"})
        EXPECT_THROW(read(grbl + block + "\nM30\n", Dialect::Grbl), Error) << block;
    const ReadProgram changed = read(grbl + "T4\nM0\nG0 Z5\nG0 X0 Y0\nG0 X1\nM30\n", Dialect::Grbl);
    EXPECT_EQ(changed.states[changed.operations[0].moves.back().state].tool, 4) << "put in at the stop";
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
