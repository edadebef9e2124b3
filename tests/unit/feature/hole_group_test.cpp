// Equal holes as one feature, and the cones below them.

#include <gtest/gtest.h>

#include "stack_maker.h"
#include "stepmill/core/units.h"
#include "stepmill/feature/hole_group.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::makeStack;

using test::kTol;
const Region kBlock = makeRectangle({0, 0}, {100, 80});

Region drilled(const Region& from, const std::vector<Vec2>& centres, double radius_mm) {
    Region left = from;
    for (const Vec2& centre : centres)
        left = subtract(left, makeCircle(centre, radius_mm), kTol);
    return left;
}

std::vector<Vec2> centresOf(const Feature& feature) {
    std::vector<Vec2> centres = holeCentres(feature);
    std::sort(centres.begin(), centres.end(),
              [](const Vec2& a, const Vec2& b) { return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y()); });
    return centres;
}

TEST(HoleGroups, EqualHolesAreOneFeature) {
    const std::vector<Vec2> centres{{20, 20}, {20, 60}, {80, 20}};
    const LayerStack stack = makeStack(kBlock, {{-10, drilled(kBlock, centres, 4)}, {-30, kBlock}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    ASSERT_EQ(set.features.size(), 1U);
    const Feature& group = set.features.front();
    EXPECT_EQ(group.feature_class, FeatureClass::HoleBlind);
    EXPECT_EQ(centresOf(group).size(), 3U);
    for (std::size_t i = 0; i < centres.size(); ++i)
        EXPECT_NEAR((centresOf(group)[i] - centres[i]).norm(), 0, 1e-9);
    EXPECT_NEAR(holeRadiusMm(group), 4, 1e-6);
    EXPECT_NEAR(group.volume_mm3, 3 * kPi * 16 * 10, 1e-2);
    EXPECT_NEAR(group.closed_length_mm, 3 * 2 * kPi * 4, 1e-3);
    EXPECT_EQ(group.point_mm, 0);
}

TEST(HoleGroups, OtherDiametersAndDepthsStayApart) {
    const Region upper = drilled(drilled(kBlock, {{20, 20}, {50, 20}}, 4), {{80, 20}}, 5);
    const Region lower = drilled(kBlock, {{20, 20}}, 4);
    const LayerStack stack = makeStack(kBlock, {{-10, upper}, {-20, lower}, {-30, kBlock}});
    EXPECT_EQ(recogniseFeatures(stack, kTol).features.size(), 3U);
}

TEST(HoleGroups, HolesBelowTwoCounterboresWaitForTheirGroup) {
    const std::vector<Vec2> centres{{20, 20}, {80, 60}};
    const LayerStack stack =
        makeStack(kBlock, {{-10, drilled(kBlock, centres, 8)}, {-30, drilled(kBlock, centres, 4)}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    ASSERT_EQ(set.features.size(), 2U);
    EXPECT_EQ(set.features[0].id, "S1.F1");
    EXPECT_EQ(set.features[1].id, "S1.F2");
    EXPECT_EQ(set.features[1].feature_class, FeatureClass::HoleThrough);
    EXPECT_EQ(set.features[1].parents, std::vector<std::string>{"S1.F1"});
}

TEST(HoleGroups, AHoleBesideAHighWallIsNoneOfThoseInTheOpen) {
    // A wall from 20 mm over the floor with the holes; 2 mm from one of them.
    const Region floor = makeRectangle({0, 0}, {100, 30});
    const Region wall = subtract(kBlock, floor, kTol);
    const LayerStack stack =
        makeStack(kBlock, {{-20, wall}, {-30, drilled(kBlock, {{20, 24}, {80, 5}, {50, 5}}, 4)}});
    std::size_t groups = 0;
    for (const Feature& feature : recogniseFeatures(stack, kTol).features)
        if (isHole(feature.feature_class)) groups += 1;
    EXPECT_EQ(groups, 2U);
}

TEST(HoleGroups, KnowsCirclesFromOtherRegions) {
    Region two = makeCircle({0, 0}, 4);
    const Region other = makeCircle({20, 0}, 4);
    two.loops.push_back(other.loops.front());
    EXPECT_TRUE(isFullCircles(two));
    two.loops.push_back(makeCircle({40, 0}, 5).loops.front());
    EXPECT_FALSE(isFullCircles(two));
    EXPECT_FALSE(isFullCircles({}));
    EXPECT_FALSE(isFullCircles(makeRectangle({0, 0}, {1, 1})));
}

/// A blind hole of 8 mm down to -10 with a cone of 118 degrees below, cut in two by a level.
LayerStack pointedHole(double level_mm) {
    const Vec2 centre(50, 40);
    const double depth_mm = 4 / std::tan(degToRad(59));
    const double at_level_mm = 4 * (depth_mm - level_mm) / depth_mm;
    LayerStack stack =
        makeStack(kBlock, {{-10, drilled(kBlock, {centre}, 4)},
                           {-10 - level_mm, level_mm > 0 ? drilled(kBlock, {centre}, at_level_mm) : kBlock},
                           {-30, kBlock}});
    FaceTrace cone;
    cone.face = static_cast<int>(stack.traces.size());
    cone.surface = SurfaceKind::Cone;
    cone.stand = FaceStand::Leaning;
    cone.cause = SlopeCause::DrillPoint;
    cone.top_z_mm = -10;
    cone.bottom_z_mm = -10 - depth_mm;
    cone.hollow = true;
    cone.radius_mm = 4;
    cone.axis_point = centre;
    stack.traces.push_back(cone);
    return stack;
}

TEST(DrillPoints, AHoleKnowsTheConeOnItsFloor) {
    const FeatureSet set = recogniseFeatures(pointedHole(1), kTol);
    ASSERT_EQ(set.features.size(), 1U);
    EXPECT_NEAR(set.features.front().point_mm, 4 / std::tan(degToRad(59)), 1e-9);
}

TEST(DrillPoints, WhatALevelShowsOfTheConeIsNoFeature) {
    const FeatureSet set = recogniseFeatures(pointedHole(1), kTol);
    double in_points_mm3 = 0;
    for (const Unplanned& entry : set.unplanned)
        if (entry.reason == Reason::DrillPoint) in_points_mm3 += entry.volume_mm3;
    const double at_level_mm = 4 - std::tan(degToRad(59));
    EXPECT_NEAR(in_points_mm3, kPi * at_level_mm * at_level_mm, 1e-3);
}

}  // namespace
}  // namespace stepmill
