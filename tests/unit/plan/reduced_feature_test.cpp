#include <gtest/gtest.h>

#include "plan/plan_warnings.h"
#include "stepmill/plan/reduced_feature.h"
#include "stepmill/planar/boolean.h"
#include "support/sample_feature.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

/// A pocket of 100 x 100 from z = 0 to -20 that leaves `left` standing.
PlannedFeature parentLeaving(const Region& left) {
    PlannedFeature parent;
    parent.feature = test::makePocket(makeRectangle(Vec2(0, 0), Vec2(100, 100)), 20);
    if (left.empty()) return parent;
    Residual residual;
    residual.region = left;
    residual.area_mm2 = area(left);
    parent.sequence.residual.push_back(residual);
    return parent;
}

/// A pocket of 40 x 40 in its floor, from z = -20 to -30.
Feature child() {
    Feature feature = test::makePocket(makeRectangle(Vec2(30, 30), Vec2(70, 70)), 10);
    feature.id = "S1.F2";
    feature.parents = {"S1.F1"};
    feature.top_z_mm = -20;
    feature.floor_z_mm = -30;
    feature.obstacles = {{-30, -20, feature.obstruction}};
    return feature;
}

TEST(Reduced, AParentThatLeavesNothingChangesNothing) {
    const PlannedFeature parent = parentLeaving({});
    const ReducedFeature free = reduced(child(), {asCut(parent)}, {asCut(parent)}, {}, kTol);
    EXPECT_TRUE(free.blocked.empty());
    EXPECT_DOUBLE_EQ(free.feature.area_mm2, 1600);
    EXPECT_EQ(free.feature.obstacles.size(), 1U);
}

TEST(Reduced, WhatLiesBelowMaterialThatStaysIsNotPlanned) {
    const PlannedFeature parent = parentLeaving(makeRectangle(Vec2(60, 0), Vec2(100, 100)));
    const ReducedFeature free = reduced(child(), {asCut(parent)}, {asCut(parent)}, {}, kTol);
    ASSERT_EQ(free.blocked.size(), 1U);
    EXPECT_NEAR(free.blocked.front().area_mm2, 400, 1e-6);
    EXPECT_NEAR(free.blocked.front().volume_mm3, 4000, 1e-5);
    EXPECT_NEAR(free.feature.area_mm2, 1200, 1e-6);
    EXPECT_LE(area(intersect(free.feature.target, parent.sequence.residual[0].region, kTol)), 1e-6);
    EXPECT_TRUE(contains(free.feature.obstruction, Vec2(65, 50)));
}

TEST(Reduced, MaterialThatParentsOnlyGoRoundIsNamedByWhoLeftIt) {
    const PlannedFeature grandparent = parentLeaving(makeRectangle(Vec2(60, 0), Vec2(100, 100)));
    PlannedFeature parent = parentLeaving({});
    parent.feature.id = "S1.F1.2";
    const ReducedFeature free =
        reduced(child(), {asCut(parent)}, {asCut(parent), asCut(grandparent)}, {}, kTol);
    ASSERT_EQ(free.blocked.size(), 1U);
    EXPECT_EQ(free.blocked.front().reason.detail, grandparent.feature.id);
}

TEST(Reduced, HoldersKeepClearOfMaterialBesideTheFeatureToo) {
    const PlannedFeature parent = parentLeaving(makeRectangle(Vec2(0, 0), Vec2(10, 100)));
    const ReducedFeature free = reduced(child(), {asCut(parent)}, {asCut(parent)}, {}, kTol);
    EXPECT_TRUE(free.blocked.empty());
    ASSERT_EQ(free.feature.obstacles.size(), 2U);
    EXPECT_EQ(free.feature.obstacles[1].bottom_z_mm, -20);
    EXPECT_EQ(free.feature.obstacles[1].top_z_mm, 0);
    EXPECT_TRUE(contains(free.feature.obstacles[1].section, Vec2(5, 50)));
}

// An obstacle may go on far over what stands: a holder passes over that, not through it.
TEST(Reduced, WhatStandsEndsWhereItDoes) {
    const PlannedFeature parent = parentLeaving(makeRectangle(Vec2(0, 0), Vec2(10, 100)));
    Feature feature = child();
    feature.obstacles = {{-30, -20, feature.obstruction}, {-20, 15, feature.obstruction}};
    const ReducedFeature free = reduced(feature, {asCut(parent)}, {asCut(parent)}, {}, kTol);
    ASSERT_EQ(free.feature.obstacles.size(), 3U);
    EXPECT_EQ(free.feature.obstacles[1].top_z_mm, 0);
    EXPECT_TRUE(contains(free.feature.obstacles[1].section, Vec2(5, 50)));
    EXPECT_EQ(free.feature.obstacles[2].bottom_z_mm, 0);
    EXPECT_EQ(free.feature.obstacles[2].top_z_mm, 15);
    EXPECT_FALSE(contains(free.feature.obstacles[2].section, Vec2(5, 50)));
}

TEST(Reduced, AFeatureAllBelowMaterialHasNothingToPlan) {
    const PlannedFeature parent = parentLeaving(makeRectangle(Vec2(0, 0), Vec2(100, 100)));
    const ReducedFeature free = reduced(child(), {asCut(parent)}, {asCut(parent)}, {}, kTol);
    EXPECT_TRUE(free.feature.target.empty());
    ASSERT_EQ(free.blocked.size(), 1U);
    EXPECT_DOUBLE_EQ(free.blocked.front().volume_mm3, child().volume_mm3);
}

TEST(Reduced, WhatAFixtureCoversStaysWithItsReason) {
    const Fixture clamp{"clamp", makeRectangle(Vec2(20, 20), Vec2(40, 80)), 0, 15};
    const ReducedFeature free = reduced(child(), {}, {}, {clamp}, kTol);
    ASSERT_EQ(free.blocked.size(), 1U);
    EXPECT_EQ(free.blocked.front().reason, Reason::Fixture);
    EXPECT_NE(free.blocked.front().advice.find("clamp"), std::string::npos);
    EXPECT_NEAR(free.blocked.front().volume_mm3, 10 * 40 * 10, 1e-6);
    EXPECT_NEAR(free.feature.area_mm2, 1600 - 400, 1e-6);
    EXPECT_TRUE(contains(free.feature.obstruction, Vec2(35, 50)));
    ASSERT_FALSE(free.feature.obstacles.empty());
    EXPECT_EQ(free.feature.obstacles.back().top_z_mm, 15);
    EXPECT_TRUE(contains(free.feature.obstacles.back().section, Vec2(25, 50)));
}

TEST(Reduced, AFixtureBelowTheFloorIsInNobodysWay) {
    const Fixture parallel{"parallel", makeRectangle(Vec2(20, 20), Vec2(40, 80)), -50, -30};
    const ReducedFeature free = reduced(child(), {}, {}, {parallel}, kTol);
    EXPECT_TRUE(free.blocked.empty());
    EXPECT_DOUBLE_EQ(free.feature.area_mm2, 1600);
    EXPECT_FALSE(contains(free.feature.obstruction, Vec2(35, 50)));
}

TEST(Reduced, JawsThatEndWhereACutBeginsAreInNobodysWayWhateverTheRounding) {
    const Fixture jaw{"jaw", makeRectangle(Vec2(20, 20), Vec2(40, 80)), -50, -30 + 4e-15};
    EXPECT_TRUE(reduced(child(), {}, {}, {jaw}, kTol).blocked.empty());
}

TEST(Reduced, CrumbsOfParentsAreCutWithTheFeature) {
    PlannedFeature parent = parentLeaving(makeRectangle(Vec2(50, 50), Vec2(50.09, 50.09)));
    parent.sequence.residual.front().reason = {Reason::LeftBetweenPasses, {}};
    EXPECT_TRUE(reduced(child(), {asCut(parent)}, {asCut(parent)}, {}, kTol).blocked.empty());
    parent.sequence.residual.front().reason = {Reason::CornerRadius, {}};
    EXPECT_FALSE(reduced(child(), {asCut(parent)}, {asCut(parent)}, {}, kTol).blocked.empty());
}

TEST(VolumeBalance, HasNoGapWhereThereIsNothingToRemove) {
    Plan plan;
    plan.balance.stock_minus_part_mm3 = kVolumeRoundingMm3 / 2;
    EXPECT_EQ(plan.balance.gapShare(), 0);
    EXPECT_TRUE(plan.complete(kTol));
}

TEST(PlanWarnings, CallAPartThatHidesMuchNot25D) {
    Plan plan;
    plan.balance.stock_minus_part_mm3 = 1000;
    plan.balance.planned_mm3 = 950;
    plan.balance.unreachable_mm3 = 50;
    plan.part.surfaces = {{"plane", 10}, {"cylinder", 4}};
    EXPECT_TRUE(warningsOf(plan, "", kTol).empty());
    plan.balance.planned_mm3 = 800;
    plan.balance.unreachable_mm3 = 200;
    const std::vector<Warning> warnings = warningsOf(plan, "", kTol);
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings[0].code, "not-2.5d");
    EXPECT_NE(warnings[0].text.find("20 %"), std::string::npos) << warnings[0].text;
}

}  // namespace
}  // namespace stepmill
