#include "stepmill/access/collision.h"

#include <gtest/gtest.h>

#include "stepmill/planar/boolean.h"
#include "support/sample_feature.h"
#include "support/tolerances.h"

using namespace stepmill;
using namespace stepmill::test;

namespace {

using test::kTol;
constexpr double kCutterMm = 3;  // radius

/// A small pocket in a large part that has two hundred round holes far away.
Feature pocketAmongHoles() {
    Feature feature = makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(30, 20), 6), 12);
    std::vector<Region> holes{feature.target};
    for (int i = 0; i < 200; ++i)
        holes.push_back(makeCircle(Vec2(100 + 12 * (i % 20), 12.0 * (i / 20)), 5));
    const Region block = makeRectangle(Vec2(-200, -200), Vec2(400, 400));
    feature.obstruction = subtract(block, unite(holes, kTol), kTol);
    feature.obstacles = {{feature.floor_z_mm, feature.top_z_mm, feature.obstruction}};
    return feature;
}

Region centresOf(const FeatureGround& ground) {
    return ground.targetOffset(-kCutterMm);
}

}  // namespace

TEST(LosesCentres, IsToldByDistanceAsByTheGrownObstacle) {
    const FeatureGround ground(pocketAmongHoles(), kTol);
    const Region centres = centresOf(ground);
    // The holder touches where it is wider than the cutter by more than half the gouge budget.
    for (const double radius_mm : {1.0, 2.9, 3.0, 3.0005, 3.002, 3.1, 8.0, 40.0}) {
        SCOPED_TRACE(radius_mm);
        const Region grown = ground.obstacleOffset(0, radius_mm - kTol.gouge_mm / 2);
        EXPECT_EQ(access::losesCentres(ground, {0, radius_mm, 5}, centres),
                  !intersect(centres, grown, kTol).empty());
    }
}

TEST(LosesCentres, InsideAnObstacleAndAroundOne) {
    Feature feature = makePocket(makeRectangle(Vec2(0, 0), Vec2(100, 100)), 12);
    feature.obstacles = {{-12, 0, makeCircle(Vec2(50, 50), 1)}, {-12, 0, makeCircle(Vec2(50, 50), 500)}};
    const FeatureGround ground(feature, kTol);
    EXPECT_TRUE(access::losesCentres(ground, {0, 5, 5}, makeRectangle(Vec2(5, 5), Vec2(95, 95))));
    EXPECT_TRUE(access::losesCentres(ground, {1, 5, 5}, makeRectangle(Vec2(5, 5), Vec2(95, 95))));
    EXPECT_FALSE(access::losesCentres(ground, {0, 5, 5}, makeRectangle(Vec2(5, 5), Vec2(40, 40))));
    EXPECT_FALSE(access::losesCentres(ground, {0, 5, 5}, {}));
}

TEST(CylindersOf, HolderButNotShankHaveTheClearance) {
    ToolAssembly tool = makeTool("EM10", ToolType::Flat, 10, 1000, 5);
    tool.flute_length_mm = 22;
    tool.stick_out_mm = 30;
    tool.shank = {12, 22, 30};
    tool.holder = {{9, 30, 40}, {40, 40, 80}};
    ASSERT_EQ(access::cylindersOf(tool).size(), 2U) << "what is no wider than the cutter follows it";
    EXPECT_DOUBLE_EQ(access::freeReachMm(tool), 22);
    tool.holder_clearance_mm = 1;
    const std::vector<HolderCylinder> cylinders = access::cylindersOf(tool);
    ASSERT_EQ(cylinders.size(), 3U);
    EXPECT_DOUBLE_EQ(cylinders[0].diameter_mm, 12);
    EXPECT_DOUBLE_EQ(access::clearanceAround(tool, cylinders[0]), 0);
    EXPECT_DOUBLE_EQ(cylinders[1].diameter_mm, 11) << "beside a wall the cutter makes it is too near";
    EXPECT_DOUBLE_EQ(cylinders[2].bottom_mm, 39);
    EXPECT_DOUBLE_EQ(access::clearanceAround(tool, cylinders[2]), 1);
}

TEST(CollisionFreeCentres, AreThoseOfTheWholeObstacleWhereOnlyItsEdgesNearbyAreGrown) {
    const FeatureGround ground(pocketAmongHoles(), kTol);
    const Region centres = centresOf(ground);
    for (const double radius_mm : {4.0, 6.0, 9.0}) {
        SCOPED_TRACE(radius_mm);
        const Region whole = subtract(centres, ground.obstacleOffset(0, radius_mm), kTol);
        const Region found = access::collisionFreeCentres(ground, {{0, radius_mm, 5}}, centres);
        EXPECT_NEAR(area(found), area(whole), 1e-6);
        EXPECT_NEAR(area(subtract(found, whole, kTol)), 0, 1e-6);
    }
}

TEST(WithoutHolder, LeavesTheTargetThatTheWholeObstacleLeaves) {
    const FeatureGround ground(pocketAmongHoles(), kTol);
    for (const double radius_mm : {5.0, 8.0}) {
        SCOPED_TRACE(radius_mm);
        const Region whole =
            subtract(ground.feature().target, ground.obstacleOffset(0, radius_mm - kCutterMm), kTol);
        const Feature found = access::withoutHolder(ground, {{0, radius_mm, 5}}, kCutterMm);
        EXPECT_NEAR(found.area_mm2, area(whole), 1e-6);
    }
}
