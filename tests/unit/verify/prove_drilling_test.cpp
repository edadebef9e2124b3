// Drills in the holes of a group.

#include <gtest/gtest.h>

#include "stepmill/core/units.h"
#include "stepmill/sequence/drilling.h"
#include "support/sample_feature.h"
#include "verify/prove_state.h"

namespace stepmill::test {
namespace {

using namespace verify;

/// Two holes of 8 mm, 15 deep, drilled by DR8.
class ProveDrilling : public testing::Test {
  protected:
    ProveDrilling() {
        Region holes = makeCircle(Vec2(20, 20), 4);
        holes.loops.push_back(makeCircle(Vec2(60, 20), 4).loops.front());
        state_.feature = makePocket(holes, 15, FeatureClass::HoleBlind);
        state_.feature.point_mm = 4 / std::tan(degToRad(59));
        state_.safe_z_mm = 0;
        planned_.id = "S1.O1";
        planned_.role = Role::Drill;
        planned_.tool = makeDrill(8);
        planned_.holes = 2;
        planned_.z_floor_mm = -15;
        planned_.step_down_mm = 20;
        operation_.id = "S1.O1";
        operation_.start = Vec3(20, 20, 5);
    }

    void go(MoveKind kind, double x, double z) {
        ReadMove move;
        move.fed.move.kind = kind;
        move.fed.move.to = Vec3(x, 20, z);
        move.line = ++line_;
        operation_.moves.push_back(move);
    }
    void hole(double x, double z) {
        go(MoveKind::Rapid, x, 5);
        go(MoveKind::Rapid, x, 1);
        go(MoveKind::Plunge, x, z);
        go(MoveKind::Rapid, x, 5);
    }
    double tipZ() const { return drillTipZ(state_.feature, planned_.tool); }

    std::size_t failuresOf() {
        proveDrilling(operation_, planned_, state_, {"S1.ngc", proof_, failures_});
        return failures_.size();
    }

    RecordedOperation planned_;
    FeatureState state_;
    ReadOperation operation_;
    OperationProof proof_;
    std::vector<ProofFailure> failures_;
    int line_ = 0;
};

TEST_F(ProveDrilling, PassesWhenEveryHoleIsDrilled) {
    hole(20, tipZ());
    hole(60, tipZ());
    EXPECT_EQ(failuresOf(), 0U);
}

TEST_F(ProveDrilling, MissesAHole) {
    hole(20, tipZ());
    ASSERT_EQ(failuresOf(), 1U);
    EXPECT_NE(failures_.front().text.find("X60.000"), std::string::npos);
}

TEST_F(ProveDrilling, FindsTheHoleThatIsNotDeepEnough) {
    hole(20, tipZ());
    hole(60, tipZ() + 0.01);
    ASSERT_EQ(failuresOf(), 1U);
    EXPECT_EQ(failures_.front().line, 7);
}

TEST_F(ProveDrilling, CountsPecksInEveryHoleByItself) {
    planned_.step_down_mm = 18;
    hole(20, tipZ());
    hole(60, tipZ());
    EXPECT_EQ(failuresOf(), 0U);
    planned_.step_down_mm = 10;
    EXPECT_EQ(failuresOf(), 1U);
}

TEST_F(ProveDrilling, AsksForAStayInEveryHole) {
    planned_.dwell_s = 0.5;
    hole(20, tipZ());
    hole(60, tipZ());
    operation_.dwells = {{0.5, 3, tipZ()}};
    EXPECT_EQ(failuresOf(), 1U);
    failures_.clear();
    operation_.dwells.push_back({0.5, 7, tipZ()});
    EXPECT_EQ(failuresOf(), 0U);
}

TEST_F(ProveDrilling, TheTipMayGoAsDeepAsThePartsPoint) {
    EXPECT_NEAR(lowestZ(planned_, state_.feature), -15 - state_.feature.point_mm, 1e-9);
    state_.feature.point_mm = 0;
    EXPECT_EQ(lowestZ(planned_, state_.feature), -15);
}

TEST_F(ProveDrilling, ADrillThatMakesRoomMayGoAsDeepAsItsPointBelowWhatItClears) {
    state_.feature.point_mm = 0;
    planned_.z_floor_mm = preDrilledToZ(state_.feature, planned_.tool);
    planned_.leaves.floors_mm = planned_.z_floor_mm + 15;
    EXPECT_NEAR(lowestZ(planned_, state_.feature), -15 + 0.1, 1e-9);
    EXPECT_EQ(clearedDownTo(planned_, state_.feature), planned_.z_floor_mm);
}

TEST_F(ProveDrilling, TheConeOfADrillClearsNothing) {
    EXPECT_EQ(clearedDownTo(planned_, state_.feature), -15);
    state_.feature.point_mm = 0;
    EXPECT_NEAR(clearedDownTo(planned_, state_.feature), -15 + 4 / std::tan(degToRad(59)), 1e-9);
}

}  // namespace
}  // namespace stepmill::test
