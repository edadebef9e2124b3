// The feature's own material in a holder's way, cut or not yet.

#include <gtest/gtest.h>

#include "support/sample_feature.h"
#include "support/tolerances.h"
#include "verify/prove_operation.h"

namespace stepmill::verify {
namespace {

using test::kTol;

/// A pocket of 60 x 20, 30 deep, and a cutter of 10 in a holder of 20 that begins 10 over the tip.
class NarrowPocket : public ::testing::Test {
  protected:
    NarrowPocket() {
        state_.feature = test::makePocket(makeRectangle(Vec2(0, 0), Vec2(60, 20)), 30);
        state_.standing = {{-30, state_.feature.target}};
        planned_.tool = test::makeTool("EM10", ToolType::Flat, 10, 1000, 5);
        planned_.tool.stick_out_mm = 10;
        planned_.tool.shank = {10, 10, 10};
        planned_.tool.holder = {{20, 10, 80}};
        planned_.z_floor_mm = -30;
        operation_.start = Vec3(10, 10, 5);
    }

    void feed(double x, double y, double z) {
        ReadMove move;
        move.fed.move.kind = MoveKind::Feed;
        move.fed.move.to = Vec3(x, y, z);
        move.line = static_cast<int>(operation_.moves.size()) + 1;
        operation_.moves.push_back(move);
    }

    /// Clears the pocket's whole width between x = 10 and 50 at this depth.
    void clearAt(double z_mm) {
        feed(5, 5, z_mm);
        for (const double y : {5.0, 10.0, 15.0}) {
            feed(5, y, z_mm);
            feed(55, y, z_mm);
            feed(5, y, z_mm);
        }
    }

    std::vector<ProofFailure> failures() const {
        OperationProof proof;
        std::vector<ProofFailure> found;
        const std::string file = "S1.ngc";
        proveHolder(operation_, planned_, state_, kTol, {file, proof, found});
        return found;
    }

    FeatureState state_;
    RecordedOperation planned_;
    ReadOperation operation_;
};

TEST_F(NarrowPocket, IsClearWhereTheHolderFollowsItsOwnWork) {
    clearAt(-5);
    feed(30, 10, -5);
    feed(30, 10, -12);  // the holder at -2, all cut down to -5
    EXPECT_TRUE(failures().empty());
}

TEST_F(NarrowPocket, IsNotWhereMaterialStandsBesideIt) {
    feed(30, 10, -12);
    EXPECT_FALSE(failures().empty());
}

TEST_F(NarrowPocket, IsNotWhereItComesNearerThanItsClearance) {
    // What stands between the ends of the passes comes to 9 mm from there, walls to 10 mm.
    planned_.tool.holder = {{16, 10, 80}};
    clearAt(-5);
    feed(50.7, 10, -5);
    feed(50.7, 10, -14);  // the holder at -4
    EXPECT_TRUE(failures().empty());
    planned_.tool.holder_clearance_mm = 0.9;
    EXPECT_TRUE(failures().empty());
    planned_.tool.holder_clearance_mm = 1.1;
    const std::vector<ProofFailure> found = failures();
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NE(found.front().text.find("with 1.1 mm of clearance"), std::string::npos) << found.front().text;
}

TEST_F(NarrowPocket, WhatWasCutForAHighHolderStandsForALowOne) {
    clearAt(-5);
    feed(30, 10, -5);
    feed(30, 10, -12);
    feed(30, 10, -25);  // the holder at -15, where nothing is cut yet
    const std::vector<ProofFailure> found = failures();
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found.front().line, static_cast<int>(operation_.moves.size()));
}

}  // namespace
}  // namespace stepmill::verify
