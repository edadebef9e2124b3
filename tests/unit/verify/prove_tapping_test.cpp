// Taps in the holes of a group.

#include <gtest/gtest.h>

#include "support/proof_failures.h"
#include "support/sample_feature.h"
#include "support/tap_makers.h"
#include "verify/prove_state.h"

namespace stepmill::test {
namespace {

using namespace verify;

/// Two holes of 6.8 mm, 18 deep, made and then tapped M8 12 deep.
class ProveTapping : public testing::Test {
  protected:
    ProveTapping() {
        Region holes = makeCircle(Vec2(20, 20), 3.4);
        holes.loops.push_back(makeCircle(Vec2(60, 20), 3.4).loops.front());
        state_.feature = makePocket(holes, 18, FeatureClass::HoleBlind);
        state_.standing = {{-18, {}}};
        state_.safe_z_mm = 0;
        planned_.id = operation_.id = "S1.O2";
        planned_.role = Role::Tap;
        planned_.tool = makeTap("M8");
        planned_.z_floor_mm = kTipZ;
        planned_.thread = {*planned_.tool.thread, kTipZ, -10, {Vec2(20, 20), Vec2(60, 20)}};
        operation_.start = Vec3(20, 20, 5);
        program_.states.emplace_back();
        program_.states.back().speed_rpm = 800;
    }

    void go(MoveKind kind, double x, double z, double pitch_mm = 0) {
        ReadMove move;
        move.fed.move.kind = kind;
        move.fed.move.to = Vec3(x, 20, z);
        move.pitch_mm = pitch_mm;
        move.line = ++line_;
        operation_.moves.push_back(move);
    }
    void hole(double x, double z, double pitch_mm = 1.25) {
        go(MoveKind::Rapid, x, 5);
        go(MoveKind::Rapid, x, 4);
        go(MoveKind::Plunge, x, z, pitch_mm);
        go(MoveKind::Feed, x, 4, pitch_mm);
        go(MoveKind::Rapid, x, 5);
    }

    /// What fails, joined.
    std::string failures() {
        failures_.clear();
        proveTapping(program_, operation_, planned_, state_, fixtures_, tol_, {"S1.ngc", proof_, failures_});
        return joined(failures_);
    }

    void expectFailure(const std::string& words) {
        const std::string found = failures();
        EXPECT_NE(found.find(words), std::string::npos) << "found: " << found;
    }

    static constexpr double kTipZ = -15;
    const Tolerances tol_;
    ReadProgram program_;
    RecordedOperation planned_;
    FeatureState state_;
    std::vector<Fixture> fixtures_;
    ReadOperation operation_;
    OperationProof proof_;
    std::vector<ProofFailure> failures_;
    int line_ = 0;
};

TEST_F(ProveTapping, PassesWhenEveryHoleIsTapped) {
    hole(20, kTipZ);
    hole(60, kTipZ);
    EXPECT_EQ(failures(), "");
}

TEST_F(ProveTapping, CountsTheHoles) {
    hole(20, kTipZ);
    expectFailure("taps 0 times at X60.000 Y20.000");
    hole(60, kTipZ);
    hole(60, kTipZ);
    expectFailure("taps 2 times at X60.000 Y20.000");
}

TEST_F(ProveTapping, FindsAnotherDepth) {
    hole(20, kTipZ - 0.01);
    hole(60, kTipZ);
    expectFailure("3: taps to Z-15.0100, planned is Z-15.0000");
}

TEST_F(ProveTapping, FindsAnotherPitch) {
    hole(20, kTipZ, 1.2501);
    hole(60, kTipZ);
    expectFailure("3: goes 1.250100 mm a turn at S800, the pitch of M8x1.25 is 1.250000 mm");
}

TEST_F(ProveTapping, APitchRoundedInTheLastDecimalOfFIsTheSame) {
    hole(20, kTipZ, 1000.005 / 800);
    hole(60, kTipZ, 999.99 / 800);
    EXPECT_EQ(failures(), "");
}

TEST_F(ProveTapping, AFeedThatIsNotCoupledStripsTheThread) {
    hole(20, kTipZ, 0);
    hole(60, kTipZ);
    expectFailure("3: feeds without the spindle's turns");
}

TEST_F(ProveTapping, ARapidInTheHoleIsFound) {
    go(MoveKind::Rapid, 20, -5);
    expectFailure("a rapid goes to Z-5.0000, into the hole");
}

TEST_F(ProveTapping, TurningRoundInTheHoleIsFound) {
    go(MoveKind::Plunge, 20, kTipZ, 1.25);
    go(MoveKind::Feed, 20, -5, 1.25);
    expectFailure("turns round in the hole");
}

TEST_F(ProveTapping, AnotherPlaceIsFound) {
    hole(20, kTipZ);
    hole(60, kTipZ);
    hole(80, kTipZ);
    expectFailure("taps at X80.000 Y20.000, which is not planned");
}

TEST_F(ProveTapping, AHoleThatIsNotMadeBeforeIsFound) {
    hole(20, kTipZ);
    hole(60, kTipZ);
    state_.standing = {{-18, makeCircle(Vec2(60, 20), 3.4)}};
    expectFailure("at X60.000 Y20.000, where the hole is not made down to there before");
}

TEST_F(ProveTapping, ACoreOfAnotherDiameterIsFound) {
    hole(20, kTipZ);
    hole(60, kTipZ);
    planned_.tool = makeTap("M10");
    planned_.thread->thread = *planned_.tool.thread;
    expectFailure("taps M10x1.5 in a hole of 6.8000 mm");
}

TEST_F(ProveTapping, ThereIsRoomForTheLeadAndForAnOverrun) {
    planned_.z_floor_mm = -17;
    hole(20, -17);
    hole(60, -17);
    expectFailure("the hole lets its tip go to Z-16.7500");
    planned_.thread->full_to_z_mm = -13;
    expectFailure("its thread cannot be whole down to Z-13.0000");
}

TEST_F(ProveTapping, AFixtureBelowAThroughHoleStopsTheTap) {
    state_.feature.through = true;
    const double tip_z = -18 - 5 - 1.25;
    planned_.z_floor_mm = tip_z;
    planned_.thread->full_to_z_mm = -18;
    hole(20, tip_z);
    hole(60, tip_z);
    EXPECT_EQ(failures(), "");
    fixtures_.push_back({"parallel", makeRectangle(Vec2(58, 0), Vec2(62, 40)), -40, -23});
    expectFailure("the hole lets its tip go to Z-16.7500");
    fixtures_.front().top_z_mm = -25;
    EXPECT_EQ(failures(), "") << "too far below to be met";
}

TEST_F(ProveTapping, AcrossItGoesOverStockAndFixtures) {
    state_.safe_z_mm = 10;
    hole(20, kTipZ);
    hole(60, kTipZ);
    expectFailure("goes across at Z5.0000, below the top of stock and fixtures");
}

TEST_F(ProveTapping, NoOtherToolGoesWithTheSpindle) {
    planned_.thread.reset();
    hole(20, kTipZ);
    expectFailure("planned is no thread");
}

}  // namespace
}  // namespace stepmill::test
