// Reamers in the holes of a group, spot drills before them.

#include <gtest/gtest.h>

#include "stepmill/sequence/spotting.h"
#include "support/hole_tool_makers.h"
#include "support/proof_failures.h"
#include "support/sample_feature.h"
#include "verify/prove_state.h"

namespace stepmill::test {
namespace {

using namespace verify;

/// A hole of 8 mm, 20 deep, drilled 7.8 and reamed to H7 down to 19.
class ProveSizing : public testing::Test {
  protected:
    ProveSizing() {
        const Region hole = makeCircle(Vec2(20, 20), 4);
        state_.feature = makePocket(hole, 20, FeatureClass::HoleBlind);
        const Region ring = subtract(hole, makeCircle(Vec2(20, 20), 3.9), tol_);
        state_.standing = {{-20, ring}, {-19, ring}};
        state_.safe_z_mm = 0;
        planned_.id = operation_.id = "S1.O2";
        planned_.role = Role::Ream;
        planned_.tool = makeReamer(8.008);
        planned_.fit = fitFrom("H7");
        planned_.holes = 1;
        planned_.z_floor_mm = -19;
        planned_.step_down_mm = 20;
        operation_.start = Vec3(20, 20, 5);
        go(MoveKind::Rapid, 1);
        go(MoveKind::Plunge, -20);
        go(MoveKind::Feed, 1);
        go(MoveKind::Rapid, 5);
    }

    void go(MoveKind kind, double z) {
        ReadMove move;
        move.fed.move.kind = kind;
        move.fed.move.to = Vec3(20, 20, z);
        move.line = ++line_;
        operation_.moves.push_back(move);
    }

    std::string failures() {
        failures_.clear();
        const Findings findings{"S1.ngc", proof_, failures_};
        proveDrilling(operation_, planned_, state_, findings);
        proveStarting(operation_, planned_, state_, findings);
        proveSizing(operation_, planned_, state_, tol_, findings);
        return joined(failures_);
    }

    void expectFailure(const std::string& words) {
        const std::string found = failures();
        EXPECT_NE(found.find(words), std::string::npos) << "found: " << found;
    }

    const Tolerances tol_;
    RecordedOperation planned_;
    FeatureState state_;
    ReadOperation operation_;
    OperationProof proof_;
    std::vector<ProofFailure> failures_;
    int line_ = 0;
};

TEST_F(ProveSizing, PassesWhenTheBoreIsReamed) {
    EXPECT_EQ(failures(), "");
}

TEST_F(ProveSizing, FindsTheBoreThatWasNotMadeBefore) {
    state_.standing[1].region = state_.standing[0].region = state_.feature.target;
    expectFailure("where no bore of 7.7300 mm is made before");
}

TEST_F(ProveSizing, FindsTheReamerOfAnotherWidth) {
    planned_.tool.diameter_mm = 8.03;
    expectFailure("H7 of 8 mm is 8.0000 to 8.0150 mm");
}

TEST_F(ProveSizing, FindsTheTipBelowTheEndOfTheBore) {
    planned_.z_floor_mm = -19.5;
    operation_.moves[1].fed.move.to.z() = -20.5;
    expectFailure("goes to Z-20.5000, the bore ends at Z-20.0000");
}

TEST_F(ProveSizing, FindsTheRapidInTheBore) {
    operation_.moves[2].fed.move.kind = MoveKind::Rapid;
    expectFailure("3: a rapid goes to Z-20.0000, into the bore");
}

TEST_F(ProveSizing, AsksForAFit) {
    planned_.fit.reset();
    expectFailure("sizes a bore to no fit");
}

TEST_F(ProveSizing, FindsTheBoreThatIsNotReamedDeepEnough) {
    operation_.moves[1].fed.move.to.z() = -19.9;
    expectFailure("drills to Z-19.9000");
}

class ProveSpotting : public ProveSizing {
  protected:
    ProveSpotting() {
        planned_.role = Role::Spot;
        planned_.tool = makeSpot(8);
        planned_.fit.reset();
        planned_.z_floor_mm = spotTipZ(state_.feature, planned_.tool);
        operation_.moves[1].fed.move.to.z() = planned_.z_floor_mm;
    }
    std::string moveFailures() {
        failures_.clear();
        proveMoves(operation_, planned_, state_, tol_, {"S1.ngc", proof_, failures_});
        return failures_.empty() ? "" : failures_.front().text;
    }
};

TEST_F(ProveSpotting, PassesInsideTheHolesEdge) {
    EXPECT_EQ(failures(), "");
    EXPECT_EQ(moveFailures(), "");
    EXPECT_TRUE(cleared(operation_, planned_, state_.feature, tol_).empty());
}

TEST_F(ProveSpotting, FindsTheConeThatIsWiderThanTheHole) {
    planned_.tool = makeSpot(20);
    planned_.z_floor_mm = -5;
    operation_.moves[1].fed.move.to.z() = -5;
    EXPECT_NE(moveFailures().find("cuts into what must stay"), std::string::npos);
}

TEST_F(ProveSpotting, FindsTheShallowHole) {
    state_.feature.floor_z_mm = -2;
    expectFailure("cannot start the hole");
}

}  // namespace
}  // namespace stepmill::test
