#include "plan/order/early_starts.h"

#include <gtest/gtest.h>

#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"
#include "support/tool_makers.h"

namespace stepmill {
namespace {

using test::makeMill;

using test::kTol;
/// Ground that the wide cutter leaves for the narrow one.
const Region kCorner = makeRectangle({40, 0}, {50, 10});

Operation levelCut(double from_x_mm, double to_x_mm, double z_mm) {
    Operation operation;
    operation.path.start = Vec3(from_x_mm, 25, 5);
    operation.path.moves.push_back({MoveKind::Plunge, Vec3(from_x_mm, 25, z_mm), {}, false});
    operation.path.moves.push_back({MoveKind::Feed, Vec3(to_x_mm, 5, z_mm), {}, false});
    return operation;
}

/// The upper feature, 50 mm wide and 10 mm deep: cut by EM16, which leaves the corner, and by EM6.
class EarlyStarts : public testing::Test {
  protected:
    EarlyStarts() {
        const Region target = makeRectangle({0, 0}, {50, 50});
        upper_planned_.feature.id = "S1.F1";
        upper_planned_.feature.floor_z_mm = -10;
        lower_planned_.feature.id = "S1.F2";
        lower_planned_.feature.parents = {"S1.F1"};
        other_planned_.feature.id = "S1.F3";
        upper_.planned = &upper_planned_;
        upper_.target = {target, 0};
        upper_.operations.push_back({&wide_, makeMill(16), subtract(target, kCorner, kTol)});
        upper_.operations.push_back({&narrow_, makeMill(6), kCorner});
    }

    std::vector<Wait> waitsOf(const Operation& operation, const ToolAssembly& tool) {
        const FeatureOperations lower{&lower_planned_, {{&operation, tool, {}}}, false};
        return earlyStarts({upper_, lower}, kTol).back().front();
    }

    PlannedFeature upper_planned_;
    PlannedFeature lower_planned_;
    PlannedFeature other_planned_;
    Operation wide_;
    Operation narrow_;
    FeatureOperations upper_;
};

TEST_F(EarlyStarts, AWideCutterGoesDownBeforeANarrowOneComes) {
    const Operation clear = levelCut(10, 30, -20);
    const std::vector<Wait> waits = waitsOf(clear, makeMill(16));
    ASSERT_EQ(waits.size(), 1U);
    EXPECT_EQ(waits[0].feature_id, "S1.F1");
    EXPECT_EQ(waits[0].operations, 1);
}

TEST_F(EarlyStarts, ACutterWaitsForWhatStandsInItsWay) {
    const Operation under_the_corner = levelCut(10, 35, -20);
    EXPECT_TRUE(waitsOf(under_the_corner, makeMill(16)).empty()) << "for all: 5 mm beside it, 8 needed";
    const Operation over_it = levelCut(10, 35, 0);
    EXPECT_EQ(waitsOf(over_it, makeMill(16)).front().operations, 0);
}

TEST_F(EarlyStarts, ANarrowCutterNeedNotWaitForItsOwnAbove) {
    const Operation clear = levelCut(10, 30, -20);
    EXPECT_EQ(waitsOf(clear, makeMill(6)).front().operations, 1);
}

TEST_F(EarlyStarts, WhatSpotDrillsTapsAndFloorsLeftOverClearIsNothing) {
    const Operation clear = levelCut(10, 30, -20);
    wide_.role = Role::Spot;
    EXPECT_TRUE(waitsOf(clear, makeMill(16)).empty());
    wide_.role = Role::Rough;
    wide_.leaves.floors_mm = 0.2;
    EXPECT_TRUE(waitsOf(clear, makeMill(16)).empty());
}

TEST_F(EarlyStarts, OverWhatStaysAtTheFloorMaterialStandsUntilItIsCut) {
    Residual residual;
    residual.region = upper_.target.region;
    residual.area_mm2 = area(residual.region);
    const auto waits = [&](double height_mm) {
        residual.volume_mm3 = height_mm * residual.area_mm2;
        upper_planned_.sequence.residual = {residual};
        return waitsOf(levelCut(10, 30, -20), makeMill(16)).front().operations;
    };
    EXPECT_EQ(waits(1), 1) << "the wide cutter clears it down to that";
    EXPECT_EQ(waits(10), 0) << "all of it stays, and is kept clear of";
}

TEST_F(EarlyStarts, FeaturesThatAreNotAboveDoNotCount) {
    const Operation clear = levelCut(10, 30, -20);
    const FeatureOperations other{&other_planned_, {{&clear, makeMill(16), {}}}, false};
    EXPECT_TRUE(earlyStarts({upper_, other}, kTol).back().front().empty());
}

TEST_F(EarlyStarts, EveryFeatureAboveIsAskedHoweverFarUp) {
    const Operation clear = levelCut(10, 30, -20);
    const Operation lowest = levelCut(10, 30, -30);
    const FeatureOperations lower{
        &lower_planned_, {{&clear, makeMill(16), kCorner}}, false, {makeRectangle({0, 0}, {50, 50}), -10}};
    other_planned_.feature.parents = {"S1.F2"};
    const FeatureOperations other{&other_planned_, {{&lowest, makeMill(16), {}}}, false};
    const std::vector<Wait> waits = earlyStarts({upper_, lower, other}, kTol).back().front();
    ASSERT_EQ(waits.size(), 2U);
    EXPECT_EQ(waits[0].feature_id, "S1.F1");
    EXPECT_EQ(waits[0].operations, 1);
    EXPECT_EQ(waits[1].feature_id, "S1.F2");
    EXPECT_EQ(waits[1].operations, 1);
}

TEST_F(EarlyStarts, AHolderWaitsWhereItWouldMeetWhatStands) {
    const Operation clear = levelCut(10, 30, -20);
    EXPECT_TRUE(waitsOf(clear, test::inHolder(makeMill(16), 15, 40)).empty())
        << "begins at Z-5, below the top, and is 20 mm wide to each side";
    EXPECT_EQ(waitsOf(clear, test::inHolder(makeMill(16), 25, 40)).front().operations, 1);
}

TEST_F(EarlyStarts, FeaturesThatTakePlainWaysAreWaitedForWholly) {
    upper_.plain_ways = true;
    const Operation clear = levelCut(10, 30, -20);
    EXPECT_TRUE(waitsOf(clear, makeMill(16)).empty());
}

}  // namespace
}  // namespace stepmill
