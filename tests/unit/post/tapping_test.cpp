// Threads in every dialect: written, read back, refused where the words do not couple feed and spindle.

#include <gtest/gtest.h>

#include "stepmill/core/error.h"
#include "stepmill/post/read_program.h"
#include "support/second_reader.h"
#include "support/tapped_plan.h"

namespace stepmill::test {
namespace {

std::string posted(Dialect dialect, bool inch = false) {
    const Plan plan = tappedPlan();
    return post(jobOf(plan, plan.setups[0]), {dialect, inch}).front().text;
}

bool holds(const std::string& text, const std::string& words) {
    return text.find(words) != std::string::npos;
}

ReadOperation lastOf(const ReadProgram& program) {
    return program.operations.back();
}

/// What the reader says of a program of one tap at X10 Y10, of which `body` taps.
std::string refusal(const std::string& body, Dialect dialect) {
    const bool fanuc = dialect == Dialect::Fanuc;
    const std::string text =
        std::string(fanuc ? "%\nO0001\n" : "") + "G21 G17 G40 G49 G80 G90 G94 G54\nT7 M6\nS800 M3\nM8\n" +
        "G43 H7\n(S1.O1 feature S1.F1)\nG0 Z5.\nG0 X10. Y10.\n" + body + "\nM30\n" + (fanuc ? "%\n" : "");
    try {
        readProgram(text, "S1", dialect);
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

TEST(TappingPost, LinuxCncCouplesBothWaysByItsPitch) {
    const std::string text = posted(Dialect::LinuxCnc);
    EXPECT_TRUE(holds(text, " G33.1 Z-15.0000 K1.25\n")) << text;
    EXPECT_FALSE(holds(text, "G84"));
    EXPECT_TRUE(holds(posted(Dialect::LinuxCnc, true), " K0.04921260\n") ||
                holds(posted(Dialect::LinuxCnc, true), " K0.0492126\n"));
}

TEST(TappingPost, FanucTapsRigidByPitchTimesSpeed) {
    const std::string text = posted(Dialect::Fanuc);
    EXPECT_TRUE(holds(text, " M29 S800\n")) << text;
    EXPECT_TRUE(holds(text, " G98 G84 X10.0000 Y40.1235 Z-15.0000 R3.7500 F1000.00\n")) << text;
    EXPECT_TRUE(holds(text, " X30.0000 Y40.1235\n"));
}

TEST(TappingPost, GrblRefusesWhatItCannotDo) {
    try {
        posted(Dialect::Grbl);
        FAIL() << "a program was written";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Usage);
        EXPECT_TRUE(holds(error.what(), "no motion coupled to the spindle")) << error.what();
    }
}

class TappedDialects : public testing::TestWithParam<std::tuple<Dialect, bool>> {};

TEST_P(TappedDialects, AreReadBackAsDownAndUpByTheThreadsPitch) {
    const auto [dialect, inch] = GetParam();
    const Plan plan = tappedPlan();
    const Operation& planned = plan.setups[0].operations.back();
    const ReadProgram program = readProgram(posted(dialect, inch), "S1", dialect);
    const ReadOperation tapped = lastOf(program);
    ASSERT_EQ(tapped.id, planned.id);
    int downs = 0;
    int ups = 0;
    Vec3 from = tapped.start;
    for (const ReadMove& read : tapped.moves) {
        const Move& move = read.fed.move;
        if (move.kind == MoveKind::Rapid) {
            EXPECT_EQ(read.pitch_mm, 0);
            EXPECT_GE(move.to.z(), 0);
        } else {
            EXPECT_NEAR(read.pitch_mm, 1.25, 2e-5);
            EXPECT_NEAR(read.fed.feed_mm_per_min, 1000, 0.0128);
            ++(move.to.z() < from.z() ? downs : ups);
        }
        from = move.to;
    }
    EXPECT_EQ(downs, 2);
    EXPECT_EQ(ups, 2);
}

TEST_P(TappedDialects, ArePostedAnewFromWhatWasRead) {
    const auto [dialect, inch] = GetParam();
    const Plan plan = tappedPlan();
    Job job = jobOf(plan, plan.setups[0]);
    const ReadProgram program = readProgram(post(job, {dialect, false}).front().text, "S1", dialect);
    JobOperation& tapped = job.operations.back();
    tapped.start = lastOf(program).start;
    tapped.moves.clear();
    for (const ReadMove& read : lastOf(program).moves)
        if (!read.home) tapped.moves.push_back(read.fed);
    // The way home at the end is the program's own.
    while (tapped.moves.back().move.to.z() > 5)
        tapped.moves.pop_back();
    EXPECT_TRUE(holds(post(job, {Dialect::Fanuc, inch}).front().text, inch ? "F39.370\n" : "F1000.00\n"));
}

INSTANTIATE_TEST_SUITE_P(Dialects, TappedDialects,
                         testing::Combine(testing::Values(Dialect::LinuxCnc, Dialect::Fanuc),
                                          testing::Bool()));

TEST(TappingReader, RefusesWhatLinuxCncRefusesAndWhatIsNoThread) {
    const auto refused = [](const std::string& body) { return refusal(body, Dialect::LinuxCnc); };
    EXPECT_EQ(refused("G33.1 Z-10 K1.25"), "");
    EXPECT_TRUE(holds(refused("G33.1 Z-10"), "G33.1 without Z and K"));
    EXPECT_TRUE(holds(refused("G33.1 K1.25"), "G33.1 without Z and K"));
    EXPECT_TRUE(holds(refused("G33.1 Z-10 K0"), "K is not over zero"));
    EXPECT_TRUE(holds(refused("G33.1 X11 Z-10 K1.25"), "at a slant"));
    EXPECT_TRUE(holds(refused("G33.1 Z10 K1.25"), "does not go down"));
    EXPECT_TRUE(holds(refused("M5\nG33.1 Z-10 K1.25"), "does not turn"));
    EXPECT_TRUE(holds(refused("G33.1 Z-10 K1.25\nX20"), "G33.1 without Z and K"));
    EXPECT_TRUE(holds(refused("G1 Z-10 F100 K1.25"), "K without G33.1"));
    EXPECT_TRUE(holds(refused("G84 Z-10 R2 F1000"), "G84 is not read"));
    EXPECT_TRUE(holds(refused("M29 S800"), "M29 is not read"));
}

TEST(TappingReader, RefusesAFanucCycleThatMayNotBeCoupled) {
    const auto refused = [](const std::string& body) { return refusal(body, Dialect::Fanuc); };
    EXPECT_EQ(refused("M29 S800\nG98 G84 X10. Y10. Z-10. R2. F1000.\nG80"), "");
    EXPECT_TRUE(holds(refused("G98 G84 X10. Y10. Z-10. R2. F1000.\nG80"), "G84 without M29"));
    EXPECT_TRUE(
        holds(refused("M29 S800\nG0 X20.\nG98 G84 X10. Y10. Z-10. R2. F1000.\nG80"), "G84 without M29"));
    EXPECT_TRUE(holds(refused("M29 S800\nG80\nG98 G84 X10. Y10. Z-10. R2. F1000.\nG80"), "G84 without M29"));
    EXPECT_TRUE(holds(refused("S0\nM29"), "M29 at S0"));
    EXPECT_TRUE(holds(refused("M29 S800\nG98 G84 X10. Y10. Z-10. F1000.\nG80"), "G84 without R"));
    EXPECT_TRUE(holds(refused("G33.1 Z-10. K1.25"), "G33.1 is not read"));
}

TEST(TappingSecondReader, LinuxCncTapsWhereWeReadItDoes) {
    STEPMILL_NEEDS_SECOND_READER();
    const Plan plan = tappedPlan();
    const SecondReader reader(posted(Dialect::LinuxCnc), toolTable(jobOf(plan, plan.setups[0])));
    ASSERT_EQ(reader.exit_code, 0) << reader.refusal;
    EXPECT_EQ(reader.count("START_SPEED_FEED_SYNC(1.250000,0)"), 2);
    EXPECT_EQ(reader.count("RIGID_TAP(10.0000, 40.1235, -15.0000)"), 1) << reader.output;
    EXPECT_EQ(reader.count("RIGID_TAP(30.0000, 40.1235, -15.0000)"), 1);
    const ReadOperation tapped = lastOf(readProgram(posted(Dialect::LinuxCnc), "S1", Dialect::LinuxCnc));
    const std::vector<CanonMotion>& motions = reader.operations.back().motions;
    std::size_t feeds = 0;
    for (const CanonMotion& motion : motions)
        feeds += motion.kind == CanonMotion::Kind::Feed;
    std::size_t read_feeds = 0;
    for (const ReadMove& read : tapped.moves)
        read_feeds += read.fed.move.kind != MoveKind::Rapid;
    EXPECT_EQ(feeds, read_feeds);
}

}  // namespace
}  // namespace stepmill::test
