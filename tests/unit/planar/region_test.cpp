#include "stepmill/planar/region.h"

#include <gtest/gtest.h>

#include <limits>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/region_text.h"

namespace stepmill {
namespace {

constexpr double kRelative = 1e-9;

Region fromText(const std::string& text) {
    return regionFromText(text, "test");
}

void expectDiagnosis(const std::string& text, const std::string& part) {
    const auto trouble = diagnose(fromText(text));
    ASSERT_TRUE(trouble.has_value()) << text;
    EXPECT_NE(trouble->find(part), std::string::npos) << *trouble;
}

/// A square plate with a square hole, in which stands a round island.
Region plateWithIsland() {
    return fromText(
        "circle 10 10 radius 2 ccw\n"
        "loop 0 0  line 20 0  line 20 20  line 0 20  close\n"
        "loop 5 5  line 5 15  line 15 15  line 15 5  close\n");
}

TEST(Region, AreaOfRoundedRectangleIsExact) {
    const Region region = makeRoundedRectangle({-3, 2}, {67, 52}, 6);
    const double expected = 70 * 50 - (4 - kPi) * 36;
    EXPECT_NEAR(area(region), expected, kRelative * expected);
    EXPECT_NEAR(perimeter(region), 2 * (58 + 38) + 12 * kPi, 1e-6);
}

TEST(Region, AreaIsExactFarFromTheOrigin) {
    const Region region = translated(makeCircle({0, 0}, 2.5), {4000, -7000});
    EXPECT_NEAR(area(region), kPi * 6.25, kRelative * 20);
}

TEST(Region, AreaOfAShallowArcKeepsItsDigits) {
    // Chord 0.1, radius 1000: theta - sin(theta) cancels to nothing when taken literally.
    const double r = 1000;
    const double half = std::asin(0.05 / r);
    Loop loop{{-0.05, 0}, {{{0.05, 0}, Arc{{0, r * std::cos(half)}, r, true}}, {{-0.05, 0}, std::nullopt}}};
    const double theta = 2 * half;
    EXPECT_NEAR(signedArea(loop) / (r * r * theta * theta * theta / 12), 1, 1e-6);
}

TEST(Region, OneFullCircleSegmentIsAWholeCircle) {
    const Loop loop{{3, 0}, {{{3, 0}, Arc{{1, 0}, 2, true}}}};
    EXPECT_NEAR(signedArea(loop), 4 * kPi, 1e-9);
    EXPECT_NEAR(length(loop), 4 * kPi, 1e-9);
    EXPECT_NEAR(signedArea(reversed(loop)), -4 * kPi, 1e-9);
    EXPECT_TRUE(contains(Region{{loop}}, {1, 1.99}));
    EXPECT_FALSE(contains(Region{{loop}}, {1, 2.01}));
    EXPECT_NEAR(boundingBox(loop).min.x(), -1, 1e-12);
    EXPECT_FALSE(diagnose(Region{{loop}}).has_value());
}

TEST(Region, BoxReachesToTheExtremesOfArcs) {
    const Region slot =
        fromText("loop 0 -1  line 5 -1  arc 5 1 centre 5 0 ccw  line 0 1  arc 0 -1 centre 0 0 ccw close");
    const Box2 box = boundingBox(slot);
    EXPECT_EQ(box.min, Vec2(-1, -1));
    EXPECT_EQ(box.max, Vec2(6, 1));
}

TEST(Region, CentroidOfAHalfDiscLiesFourThirdsOfRadiusOverPi) {
    const Region half = fromText("loop 7 2  line 13 2  arc 7 2 centre 10 2 ccw  close");
    EXPECT_NEAR(centroid(half).x(), 10, 1e-9);
    EXPECT_NEAR(centroid(half).y(), 2 + 4 * 3 / (3 * kPi), 1e-9);
}

TEST(Region, ContainsKnowsHolesIslandsAndTheBoundary) {
    const Region region = plateWithIsland();
    EXPECT_TRUE(contains(region, {1, 1}));
    EXPECT_FALSE(contains(region, {6, 6}));
    EXPECT_TRUE(contains(region, {10, 10}));
    EXPECT_TRUE(contains(region, {20, 20}));
    EXPECT_TRUE(contains(region, {5, 10}));
    EXPECT_FALSE(contains(region, {20.001, 10}));
    EXPECT_FALSE(contains(Region{}, {0, 0}));
}

TEST(Region, ContainsHoldsAtTheHeightOfVerticesAndOnExtendedEdges) {
    const Region star = fromText("loop 0 0  line 4 0  line 4 4  line 2 2  line 0 4  close");
    EXPECT_FALSE(contains(star, {-1, 4}));
    EXPECT_FALSE(contains(star, {2, 4}));
    EXPECT_TRUE(contains(star, {1, 2}));
    EXPECT_FALSE(contains(star, {-1, 0}));
    EXPECT_FALSE(contains(star, {5, 2}));
}

TEST(Region, DistanceToBoundaryIsInfiniteForTheEmptyRegion) {
    EXPECT_EQ(distanceToBoundary(Region{}, {0, 0}), std::numeric_limits<double>::infinity());
    EXPECT_NEAR(distanceToBoundary(plateWithIsland(), {10, 10}), 2, 1e-12);
    EXPECT_NEAR(distanceToBoundary(plateWithIsland(), {23, 24}), 5, 1e-12);
}

TEST(Region, ComponentsCarryTheirHolesInOrderOfLowestPoint) {
    const std::vector<Region> parts = components(plateWithIsland());
    ASSERT_EQ(parts.size(), 2u);
    EXPECT_EQ(parts[0].loops.size(), 2u);
    EXPECT_NEAR(area(parts[0]), 300, 1e-9);
    EXPECT_EQ(parts[1].loops.size(), 1u);
}

TEST(Region, ComponentsThrowOnAHoleOutside) {
    const Region region =
        fromText("circle 0 0 radius 1 ccw\ncircle 9 0 radius 1 ccw\ncircle 5 5 radius 1 cw");
    try {
        components(region);
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::InvalidRegion);
    }
}

TEST(Region, WithoutHolesFillsIslandsToo) {
    EXPECT_EQ(withoutHoles(plateWithIsland()).loops.size(), 1u);
    EXPECT_NEAR(area(withoutHoles(plateWithIsland())), 400, 1e-9);
}

TEST(Region, PointAndTangentFollowTheArc) {
    const Segment quarter{{0, 2}, Arc{{0, 0}, 2, true}};
    const Vec2 middle = pointAt({2, 0}, quarter, 0.5);
    EXPECT_NEAR(middle.x(), std::sqrt(2), 1e-12);
    EXPECT_NEAR(tangentAt({2, 0}, quarter, 0.5).x(), -std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(sweepAngle({2, 0}, {0, 2}, Arc{{0, 0}, 2, false}), -1.5 * kPi, 1e-12);
}

TEST(Region, TessellationKeepsTheChordAndThePointsLieOnTheCurve) {
    const Path path = makeCircle({1, 2}, 10).loops.front();
    const double chord_mm = 0.01;
    const std::vector<Vec2> points = tessellate(path, chord_mm);
    EXPECT_EQ(points.front(), points.back());
    for (std::size_t i = 1; i < points.size(); ++i) {
        EXPECT_NEAR((points[i] - Vec2(1, 2)).norm(), 10, 1e-6);
        EXPECT_GE((0.5 * (points[i - 1] + points[i]) - Vec2(1, 2)).norm(), 10 - chord_mm - 1e-6);
    }
}

TEST(Region, PolygonIsTurnedCounterClockwise) {
    EXPECT_GT(area(makePolygon({{0, 0}, {0, 1}, {1, 1}})), 0);
}

TEST(Diagnose, AcceptsWhatTheRulesAllow) {
    EXPECT_FALSE(diagnose(Region{}).has_value());
    EXPECT_FALSE(diagnose(plateWithIsland()).has_value());
    EXPECT_FALSE(diagnose(makeRoundedRectangle({0, 0}, {10, 10}, 5)).has_value());
    // Two squares that touch at a corner, a hole that touches the wall.
    EXPECT_FALSE(diagnose(fromText("loop 0 0 line 1 0 line 1 1 line 0 1 close\n"
                                   "loop 1 1 line 2 1 line 2 2 line 1 2 close"))
                     .has_value());
    EXPECT_FALSE(diagnose(fromText("circle 0 0 radius 5 ccw\ncircle 3 0 radius 2 cw")).has_value());
}

TEST(Diagnose, NamesOpenLoops) {
    Region region = makeRectangle({0, 0}, {2, 1});
    region.loops.front().segments.pop_back();
    EXPECT_EQ(diagnose(region),
              "the loop from (0.000000, 0.000000) ends at (0.000000, 1.000000): not closed");
}

TEST(Diagnose, NamesArcsOffTheirCircle) {
    expectDiagnosis("loop 0 0  line 4 0  arc 0 0 centre 2 0 radius 2.00001 ccw  close",
                    "off its circle, centre (2.000000, 0.000000)");
}

TEST(Diagnose, NamesEdgesWithoutLength) {
    expectDiagnosis("loop 0 0  line 4 0  line 4 0  line 0 4  close", "no length at (4.000000, 0.000000)");
}

TEST(Diagnose, NamesCrossings) {
    expectDiagnosis("loop 0 0  line 4 4  line 4 0  line 0 4  close", "edges cross at");
    expectDiagnosis("circle 0 0 radius 2 ccw\ncircle 3 0 radius 2 ccw", "edges cross at (1.5");
    expectDiagnosis("loop 0 0 line 4 0 line 4 4 line 0 4 close\nloop 2 1 line 6 1 line 6 3 line 2 3 close",
                    "edges cross at (4");
}

TEST(Diagnose, NamesSharedEdgesAndSpikes) {
    expectDiagnosis("loop 0 0 line 4 0 line 4 4 line 0 4 close\nloop 4 0 line 8 0 line 8 4 line 4 4 close",
                    "run along each other at (4");
    expectDiagnosis("loop 0 0 line 4 0 line 9 0 line 4 0 line 4 4 close", "runs back over the one before");
}

TEST(Diagnose, NamesWrongOrientation) {
    expectDiagnosis("circle 1 2 radius 1 cw", "lies outside all outer loops");
    expectDiagnosis("circle 0 0 radius 5 ccw\ncircle 0 0 radius 2 ccw", "inside another one");
    expectDiagnosis("circle 0 0 radius 5 ccw\ncircle 9 0 radius 2 cw", "lies outside all outer loops");
}

TEST(Diagnose, ValidateThrowsWithTheSubject) {
    try {
        validate(fromText("circle 1 2 radius 1 cw"), "pocket P3");
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::InvalidRegion);
        EXPECT_EQ(error.subject(), "pocket P3");
    }
}

}  // namespace
}  // namespace stepmill
