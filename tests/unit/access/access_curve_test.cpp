#include <cmath>

#include <gtest/gtest.h>

#include "stepmill/access/access_curve.h"
#include "stepmill/core/units.h"
#include "support/grounds.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::closedPocket;
using test::makeFeature;

using test::kTol;

Region rect(double x0, double y0, double x1, double y1) {
    return makeRectangle({x0, y0}, {x1, y1});
}

/// What a cutter wider than a right-angled corner's radius leaves in it.
double leftInCorner(double radius_mm, double corner_mm) {
    return radius_mm > corner_mm ? (1 - kPi / 4) * (radius_mm * radius_mm - corner_mm * corner_mm) : 0;
}

AccessCurve curveOf(const Feature& feature, double to_mm) {
    return accessCurve(FeatureGround(feature, kTol), 0, to_mm);
}

std::vector<AccessEvent> ofKind(const AccessCurve& curve, AccessEventKind kind) {
    std::vector<AccessEvent> found;
    for (const AccessEvent& event : curve.events)
        if (event.kind == kind) found.push_back(event);
    return found;
}

void expectFalling(const AccessCurve& curve) {
    for (std::size_t i = 1; i < curve.samples.size(); ++i) {
        EXPECT_GT(curve.samples[i].diameter_mm, curve.samples[i - 1].diameter_mm);
        EXPECT_LE(curve.samples[i].area_mm2, curve.samples[i - 1].area_mm2 + kTol.area_mm2)
            << curve.samples[i].diameter_mm;
    }
}

TEST(AccessCurve, OfARoundedPocketBendsAtItsCornerRadiusAndEndsAtItsWidth) {
    const AccessCurve curve = curveOf(closedPocket(makeRoundedRectangle({0, 0}, {40, 30}, 5)), 35);
    expectFalling(curve);

    const auto corners = ofKind(curve, AccessEventKind::CornerRadius);
    ASSERT_EQ(corners.size(), 1u);
    EXPECT_DOUBLE_EQ(corners[0].diameter_mm, 10);
    ASSERT_EQ(corners[0].at.size(), 4u);
    EXPECT_EQ(corners[0].at[0], Vec2(5, 5));
    EXPECT_EQ(corners[0].at[3], Vec2(35, 25));
    EXPECT_NEAR(corners[0].area_before_mm2, corners[0].area_after_mm2, 1e-2);

    const auto necks = ofKind(curve, AccessEventKind::Neck);
    ASSERT_EQ(necks.size(), 1u);
    EXPECT_NEAR(necks[0].diameter_mm, 30, 1e-6);
    EXPECT_NEAR(necks[0].area_before_mm2, 1200 - 4 * leftInCorner(15, 0), 0.05);
    EXPECT_EQ(necks[0].area_after_mm2, 0);
    EXPECT_TRUE(ofKind(curve, AccessEventKind::Vanishes).empty());
}

TEST(AccessCurve, IsNoFartherOffBetweenSamplesThanItSays) {
    const double whole = 1200 - 4 * leftInCorner(5, 0);
    const AccessCurve curve = curveOf(closedPocket(makeRoundedRectangle({0, 0}, {40, 30}, 5)), 35);
    EXPECT_LE(curve.max_error_mm2, 1.2);
    for (double d = 0.05; d < 30; d += 0.31) {
        EXPECT_NEAR(curve.areaAt(d), whole - 4 * leftInCorner(d / 2, 5), curve.max_error_mm2) << d;
        EXPECT_NEAR(curve.volumeAt(d), 10 * curve.areaAt(d), 1e-6);
    }
    EXPECT_EQ(curve.areaAt(30.5), 0);
    EXPECT_LT(curve.samples.size(), 200u);
}

TEST(AccessCurve, OfASharpCorneredRectangleHasNoCornerRadius) {
    const AccessCurve curve = curveOf(closedPocket(rect(0, 0, 40, 30)), 35);
    EXPECT_TRUE(ofKind(curve, AccessEventKind::CornerRadius).empty());
    EXPECT_NEAR(curve.areaAt(10), 1200 - 4 * leftInCorner(5, 0), curve.max_error_mm2);
    EXPECT_DOUBLE_EQ(curve.areaAt(0), 1200);
}

TEST(AccessCurve, JumpsWhereACorridorIsAsWideAsTheCutter) {
    // Two rooms, 30 and 20 mm wide, joined by a corridor 8 mm wide and 20 mm long.
    const Region rooms =
        unite(std::vector{rect(0, 0, 30, 30), rect(30, 11, 50, 19), rect(50, 5, 70, 25)}, kTol);
    const AccessCurve curve = curveOf(closedPocket(rooms), 35);
    expectFalling(curve);
    const auto necks = ofKind(curve, AccessEventKind::Neck);
    ASSERT_FALSE(necks.empty());
    EXPECT_NEAR(necks[0].diameter_mm, 8, 1e-6);
    ASSERT_EQ(necks[0].at.size(), 1u);
    EXPECT_NEAR(necks[0].at[0].x(), 40, 1e-6);
    EXPECT_NEAR(necks[0].at[0].y(), 15, 1e-6);
    // All of the corridor is lost but where discs in the rooms bulge into its ends.
    EXPECT_GT(necks[0].area_before_mm2 - necks[0].area_after_mm2, 8 * 20 - 2 * 8 * 4);
    EXPECT_LT(necks[0].area_before_mm2 - necks[0].area_after_mm2, 8 * 20);
}

TEST(AccessCurve, NamesANeckBetweenTwoCornersThatSplitsTheCentres) {
    // A bow tie: 40 mm wide rooms that meet in a waist of 6 mm.
    const Region bow = makePolygon({{0, 0}, {40, 17}, {80, 0}, {80, 40}, {40, 23}, {0, 40}});
    const AccessCurve curve = curveOf(closedPocket(bow), 40);
    expectFalling(curve);
    const auto necks = ofKind(curve, AccessEventKind::Neck);
    ASSERT_EQ(necks.size(), 1u);
    EXPECT_NEAR(necks[0].diameter_mm, 6, 1e-6);
    EXPECT_NEAR((necks[0].at[0] - Vec2(40, 20)).norm(), 0, 1e-6);
    EXPECT_NEAR(necks[0].area_before_mm2, necks[0].area_after_mm2, 0.05);

    const auto last = ofKind(curve, AccessEventKind::Vanishes);
    ASSERT_EQ(last.size(), 1u);
    EXPECT_EQ(last[0].at.size(), 2u);
    EXPECT_EQ(last[0].area_after_mm2, 0);
    const auto disc = FeatureGround(closedPocket(bow), kTol).widestDiscInTarget();
    EXPECT_NEAR(last[0].diameter_mm, 2 * disc->radius_mm, 2 * kTol.linear_mm);
    EXPECT_NEAR(last[0].area_before_mm2, 2 * kPi * disc->radius_mm * disc->radius_mm, 0.1);
}

TEST(AccessCurve, OfARoundHoleEndsAtItsDiameterWithOneEvent) {
    const AccessCurve curve = curveOf(closedPocket(makeCircle({3, 4}, 6)), 20);
    ASSERT_EQ(curve.events.size(), 1u);
    EXPECT_EQ(curve.events[0].kind, AccessEventKind::Vanishes);
    EXPECT_NEAR(curve.events[0].diameter_mm, 12, kTol.linear_mm);
    EXPECT_NEAR(curve.events[0].area_before_mm2, kPi * 36, 1e-2);
    EXPECT_EQ(curve.events[0].area_after_mm2, 0);
    EXPECT_NEAR((curve.events[0].at[0] - Vec2(3, 4)).norm(), 0, 1e-3);
}

TEST(AccessCurve, OfAnOpenSlotEndsAtItsWidthAndIsConstantBefore) {
    // A slot 12 mm wide through a block, open at both ends.
    const Region target = rect(0, 0, 50, 12);
    const Region walls = unite(rect(0, -20, 50, 0), rect(0, 12, 50, 32), kTol);
    const AccessCurve curve = curveOf(makeFeature(target, walls, 24), 20);
    expectFalling(curve);
    EXPECT_NEAR(curve.areaAt(3), 600, 0.1);
    EXPECT_NEAR(curve.areaAt(11.9), 600, 0.1);
    ASSERT_EQ(ofKind(curve, AccessEventKind::Neck).size(), 1u);
    EXPECT_NEAR(ofKind(curve, AccessEventKind::Neck)[0].diameter_mm, 12, 1e-6);
}

TEST(AccessCurve, OfAFaceWithoutWallsIsConstant) {
    const AccessCurve curve = curveOf(makeFeature(rect(0, 0, 50, 40), {}, 180), 100);
    EXPECT_TRUE(curve.events.empty());
    for (const AccessSample& sample : curve.samples)
        EXPECT_NEAR(sample.area_mm2, 2000, 1e-3) << sample.diameter_mm;
}

TEST(AccessCurve, DoesNotAskHowAToolGetsIn) {
    // A hole a cutter just fits leaves no room for a helix or a ramp; the curve counts it all the same.
    const AccessCurve curve = curveOf(closedPocket(makeCircle({0, 0}, 5)), 9.9);
    EXPECT_NEAR(curve.samples.back().area_mm2, kPi * 25, 1e-2);
}

}  // namespace
}  // namespace stepmill
