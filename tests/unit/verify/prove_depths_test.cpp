#include <gtest/gtest.h>

#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"
#include "verify/prove_operation.h"

namespace stepmill::verify {
namespace {

using test::kTol;
constexpr double kStepDownMm = 4;

/// A 10 mm cutter along y = 0 in a trough 10 mm wide and 10 mm deep, from x = 0 to 40.
class ProveDepths : public testing::Test {
  protected:
    ProveDepths() {
        planned_.tool.diameter_mm = 10;
        planned_.tool.max_plunge_mm = kStepDownMm;
        planned_.step_down_mm = kStepDownMm;
        planned_.z_floor_mm = -10;
        state_.feature.floor_z_mm = -10;
        state_.standing = {{-10, makeRectangle({-5, -5}, {45, 5})}};
        operation_.start = {0, 0, 5};
    }

    /// One more line of the program.
    void go(MoveKind kind, double x, double y, double z) {
        ReadMove move;
        move.fed.move.kind = kind;
        move.fed.move.to = {x, y, z};
        move.line = ++line_;
        operation_.moves.push_back(move);
    }

    /// Down, along the trough, and up again.
    void pass(double z, double y = 0, double to_x = 40) {
        go(MoveKind::Plunge, 0, y, z);
        go(MoveKind::Feed, to_x, y, z);
        go(MoveKind::Rapid, to_x, y, 5);
        go(MoveKind::Rapid, 0, y, 5);
    }

    void prove() { proveDepths(operation_, planned_, state_, kTol, {"S1.ngc", proof_, failures_}); }

    RecordedOperation planned_;
    FeatureState state_;
    ReadOperation operation_;
    OperationProof proof_;
    std::vector<ProofFailure> failures_;
    int line_ = 0;
};

TEST_F(ProveDepths, LevelsAStepDownApartPass) {
    for (const double z : {-4.0, -8.0, -10.0})
        pass(z);
    prove();
    EXPECT_TRUE(failures_.empty());
    EXPECT_DOUBLE_EQ(proof_.depth_of_cut_mm, kStepDownMm);
}

TEST_F(ProveDepths, ALevelLeftOutIsShownWhereTheNextOneCuts) {
    for (const double z : {-4.0, -10.0})
        pass(z);
    prove();
    ASSERT_EQ(failures_.size(), 1U);
    EXPECT_EQ(failures_[0].line, 5) << "the plunge to Z-10";
    EXPECT_NE(failures_[0].text.find("more than the planned 4 mm"), std::string::npos);
}

TEST_F(ProveDepths, AFirstLevelTooDeepIsShown) {
    pass(-4.01);
    prove();
    EXPECT_EQ(failures_.size(), 1U);
}

TEST_F(ProveDepths, RoundedHeightsPass) {
    // Each as far off as words in inches may be that were mm with four decimals before.
    pass(-4 + 1.7e-4);
    pass(-8 - 1.7e-4);
    prove();
    EXPECT_TRUE(failures_.empty());
}

TEST_F(ProveDepths, ALevelThatEndsEarlyDoesNotCarryTheNextOne) {
    pass(-4, 0, 20);
    pass(-8);
    prove();
    ASSERT_EQ(failures_.size(), 1U);
    EXPECT_EQ(failures_[0].line, 6) << "the pass, not the plunge before it";
}

TEST_F(ProveDepths, OtherWaysOverTheSameGroundPass) {
    pass(-4);
    // The lower level comes from the other end, in two pieces.
    go(MoveKind::Rapid, 40, 0, 5);
    go(MoveKind::Plunge, 40, 0, -8);
    go(MoveKind::Feed, 15, 0, -8);
    go(MoveKind::Feed, 0, 0, -8);
    prove();
    EXPECT_TRUE(failures_.empty());
}

TEST_F(ProveDepths, ARampBetweenLevelsPasses) {
    pass(-4);
    go(MoveKind::Rapid, 0, 0, -3.9);
    go(MoveKind::Ramp, 30, 0, -6);
    go(MoveKind::Ramp, 0, 0, -8);
    go(MoveKind::Feed, 40, 0, -8);
    prove();
    EXPECT_TRUE(failures_.empty());
}

TEST_F(ProveDepths, TurnsOfARampCarryEachOther) {
    go(MoveKind::Plunge, 0, 0, 0.2);
    for (double z = 0.2; z > -8; z -= 3) {
        go(MoveKind::Ramp, 40, 0, z - 1.5);
        go(MoveKind::Ramp, 0, 0, z - 3);
    }
    go(MoveKind::Feed, 40, 0, -8.8);
    prove();
    EXPECT_TRUE(failures_.empty());
    // Each turn sinks 3 mm; what is said allows for ramps.
    EXPECT_GE(proof_.depth_of_cut_mm, 3);
    EXPECT_LE(proof_.depth_of_cut_mm, kStepDownMm + 0.3);
}

TEST_F(ProveDepths, ARampThatIsTooSteepIsShown) {
    go(MoveKind::Plunge, 0, 0, 0.2);
    go(MoveKind::Ramp, 40, 0, -3.5);
    go(MoveKind::Ramp, 0, 0, -7);
    prove();
    ASSERT_EQ(failures_.size(), 1U);
    EXPECT_EQ(failures_[0].line, 3);
}

TEST_F(ProveDepths, GroundThatWasClearedBeforeIsFree) {
    state_.standing = {{-10, makeRectangle({30, -5}, {45, 5})}};
    pass(-10, 0, 24);
    prove();
    EXPECT_TRUE(failures_.empty());
    pass(-10, 0, 26);
    prove();
    EXPECT_EQ(failures_.size(), 1U);
}

TEST_F(ProveDepths, AFloorPassCountsOnWhatRoughingClearedOverIt) {
    // Roughing left half a millimetre on the floor and nothing else.
    state_.standing = {{-10, makeRectangle({-5, -5}, {45, 5})}, {-9.5, {}}};
    planned_.step_down_mm = 0.5;
    pass(-10);
    prove();
    EXPECT_TRUE(failures_.empty());
    state_.standing.back().z_mm = -9;
    prove();
    EXPECT_EQ(failures_.size(), 1U);
}

TEST_F(ProveDepths, ADrillMayPeck) {
    planned_.tool.type = ToolType::Drill;
    pass(-10);
    prove();
    EXPECT_TRUE(failures_.empty());
    EXPECT_EQ(proof_.depth_of_cut_mm, 0);
}

TEST_F(ProveDepths, APlungeIntoTheSolidIsNoDeeperThanTheToolMayGo) {
    planned_.tool.max_plunge_mm = 1;
    pass(-4);
    prove();
    ASSERT_EQ(failures_.size(), 1U);
    EXPECT_EQ(failures_[0].line, 1);
    EXPECT_NE(failures_[0].text.find("more than the 1 mm it may plunge"), std::string::npos)
        << failures_[0].text;
}

TEST_F(ProveDepths, APlungeMayGoAsDeepAsItLikesWhereNothingStands) {
    planned_.tool.max_plunge_mm = 0;
    state_.standing = {{-10, makeRectangle({10, -5}, {45, 5})}};
    pass(-4);
    pass(-8);
    prove();
    EXPECT_TRUE(failures_.empty());
}

TEST_F(ProveDepths, ARampNoSteeperThanPlannedIsNoPlunge) {
    planned_.tool.max_plunge_mm = 0;
    planned_.ramp_angle_deg = 6;  // 4 mm over 40
    go(MoveKind::Rapid, 0, 0, 0);
    go(MoveKind::Ramp, 40, 0, -4);
    go(MoveKind::Feed, 0, 0, -4);
    prove();
    EXPECT_TRUE(failures_.empty());
}

TEST_F(ProveDepths, ARampSteeperThanPlannedIsAPlunge) {
    planned_.tool.max_plunge_mm = 0;
    planned_.ramp_angle_deg = 5;
    go(MoveKind::Rapid, 0, 0, 0);
    go(MoveKind::Ramp, 40, 0, -4);
    go(MoveKind::Feed, 0, 0, -4);
    prove();
    ASSERT_EQ(failures_.size(), 1U);
    EXPECT_EQ(failures_[0].line, 2);
    EXPECT_NE(failures_[0].text.find("steeper"), std::string::npos) << failures_[0].text;
}

}  // namespace
}  // namespace stepmill::verify
