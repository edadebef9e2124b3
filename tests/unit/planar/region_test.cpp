#include "stepmill/planar/region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "planar/segment.h"
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
    EXPECT_NEAR(boundingBox(loop).min().x(), -1, 1e-12);
    EXPECT_FALSE(diagnose(Region{{loop}}).has_value());
}

TEST(Region, BoxReachesToTheExtremesOfArcs) {
    const Region slot =
        fromText("loop 0 -1  line 5 -1  arc 5 1 centre 5 0 ccw  line 0 1  arc 0 -1 centre 0 0 ccw close");
    const Box2 box = boundingBox(slot);
    EXPECT_EQ(box.min(), Vec2(-1, -1));
    EXPECT_EQ(box.max(), Vec2(6, 1));
}

TEST(Region, CentroidOfAHalfDiscLiesFourThirdsOfRadiusOverPi) {
    const Region half = fromText("loop 7 2  line 13 2  arc 7 2 centre 10 2 ccw  close");
    EXPECT_NEAR(centroid(half).x(), 10, 1e-9);
    EXPECT_NEAR(centroid(half).y(), 2 + 4 * 3 / (3 * kPi), 1e-9);
}

/// Relative to the moment, and to what the coordinates' own last digits make of it.
void expectMoments(const Region& region, double area_mm2, const Vec2& centre, double xx, double xy,
                   double yy) {
    const Moments m = moments(region);
    constexpr double kDigits = 1e-12;
    EXPECT_NEAR(m.area_mm2, area_mm2, kDigits * area_mm2);
    EXPECT_NEAR(m.area_mm2, area(region), kDigits * area_mm2);
    const double size = boundingBox(region).sizes().norm();
    EXPECT_NEAR((m.centroid - centre).norm(), 0, kDigits * size);
    const double polar = xx + yy;
    EXPECT_NEAR(m.second_mm4(0, 0), xx, kDigits * polar);
    EXPECT_NEAR(m.second_mm4(0, 1), xy, kDigits * polar);
    EXPECT_NEAR(m.second_mm4(1, 0), xy, kDigits * polar);
    EXPECT_NEAR(m.second_mm4(1, 1), yy, kDigits * polar);
}

TEST(RegionMoments, OfARectangleAndATriangleAreThoseOfTheBook) {
    expectMoments(makeRectangle({-1, 2}, {5, 6}), 24, {2, 4}, 4 * 216 / 12.0, 0, 6 * 64 / 12.0);
    const double b = 6, h = 9;
    expectMoments(makePolygon({{0, 0}, {b, 0}, {0, h}}), 27, {2, 3}, h * b * b * b / 36, -b * b * h * h / 72,
                  b * h * h * h / 36);
}

TEST(RegionMoments, OfDiscsRingsAndHalfDiscsAreExact) {
    const double disc = kPi * 625 / 4;
    expectMoments(makeCircle({3, -2}, 5), kPi * 25, {3, -2}, disc, 0, disc);
    Region ring = makeCircle({3, -2}, 5);
    ring.loops.push_back(reversed(makeCircle({3, -2}, 3).loops.front()));
    const double hollow = kPi * (625 - 81) / 4;
    expectMoments(ring, kPi * 16, {3, -2}, hollow, 0, hollow);
    const double r = 3;
    const double above = 4 * r / (3 * kPi);
    expectMoments(fromText("loop 7 2  line 13 2  arc 7 2 centre 10 2 ccw  close"), kPi * r * r / 2,
                  {10, 2 + above}, kPi * r * r * r * r / 8, 0,
                  kPi * r * r * r * r / 8 - kPi * r * r / 2 * above * above);
}

TEST(RegionMoments, DoNotDependOnWhereTheRegionLies) {
    const Region region = makeRoundedRectangle({0, 0}, {8, 4}, 1);
    const Moments here = moments(region);
    const Moments there = moments(translated(region, {4096, -8192}));
    EXPECT_NEAR(there.area_mm2, here.area_mm2, 1e-12 * here.area_mm2);
    EXPECT_NEAR((there.second_mm4 - here.second_mm4).norm(), 0, 1e-12 * here.second_mm4.norm());
}

TEST(RegionMoments, OfAShallowArcKeepTheirDigits) {
    // A parabola to fifteen digits: chord c, sagitta s, area 2/3 c s, centre at 2/5 s above the chord.
    const double r = 4e5;
    const Vec2 a(-0.5, 0), b(0.5, 0);
    const double up = std::sqrt(r * r - 0.25);
    const Region cap{{Loop{a, {{b, Arc{{0, up}, r, true}}, {a, std::nullopt}}}}};
    const Moments m = moments(cap);
    const double s = 0.25 / (r + up);
    EXPECT_NEAR(m.area_mm2, 2.0 / 3 * s, 1e-9 * s);
    EXPECT_NEAR(m.centroid.y(), -0.4 * s, 1e-9 * s);
    EXPECT_NEAR(m.second_mm4(0, 0), s / 30, 1e-9 * s);
}

/// The winding of the polygon through many points of the loop.
int windingOfPolygon(const std::vector<Vec2>& points, const Vec2& p) {
    int winding = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec2 a = points[i - 1] - p;
        const Vec2 b = points[i] - p;
        if ((a.y() <= 0) == (b.y() <= 0)) continue;
        const double left = cross(a, b);
        if (b.y() > 0 && left > 0) ++winding;
        if (b.y() <= 0 && left < 0) --winding;
    }
    return winding;
}

TEST(Region, ContainsIsRightBesideArcsOfAFewNanometres) {
    std::mt19937 random(1);
    const auto real = [&](double low, double high) { return low + (high - low) * (random() / 4294967296.0); };
    int asked = 0;
    for (int i = 0; i < 20000; ++i) {
        // Radii from 2 nm to 10 mm, arcs from 1 nm length; the ends are on the grid and so off the circle.
        const double r = std::max(2 * kGridMm, snapToGrid(std::pow(10.0, real(-5.7, 1))));
        const double sweep = std::min(std::pow(10.0, real(-6, -3.5)) / r, real(0.1, 6));
        const double begin = real(0, 2 * kPi);
        const auto at = [&](double angle) {
            return snapToGrid(Vec2(r * std::cos(angle), r * std::sin(angle)));
        };
        const Arc arc{{0, 0}, r, i % 2 == 0};
        const Vec2 p = at(begin);
        const Vec2 q = at(begin + (arc.ccw ? sweep : -sweep));
        if (p == q || std::abs(std::abs(sweepAngle(p, q, arc)) - sweep) > 1.5) continue;
        const Vec2 third = snapToGrid(Vec2(q + Vec2(real(-5, 5), real(-5, 5))));
        Loop loop{p, {{q, arc}, {third, std::nullopt}, {p, std::nullopt}}};
        if (signedArea(loop) < 0) loop = reversed(loop);
        const std::vector<Vec2> polygon = tessellate(loop, 1e-9);
        for (int k = 0; k < 10; ++k) {
            const double away = std::pow(10.0, real(-5.5, 0.5));
            const double angle = real(0, 2 * kPi);
            Vec2 seen = p + away * Vec2(std::cos(angle), std::sin(angle));
            if (k % 3 == 0) seen.y() = k % 2 ? p.y() : q.y();
            if (distanceToBoundary(Region{{loop}}, seen) < 5 * kGridMm) continue;
            ++asked;
            ASSERT_EQ(contains(Region{{loop}}, seen), windingOfPolygon(polygon, seen) > 0)
                << toText(Region{{loop}}) << seen.transpose();
        }
    }
    EXPECT_GT(asked, 100000);
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

TEST(Region, ComponentsKeepAHoleThatReachesOutAsFarAsLoopsMayTouch) {
    // From the stock of a real part: the hole's corner is 4 nm outside the wall that it touches.
    const Region outer = makePolygon({{23.249966, 147.347352},
                                      {24.423955, 147.779285},
                                      {24.372387, 149.075854},
                                      {22.940234, 151.212095},
                                      {22.940234, 148.655484}});
    Region region = makePolygon({{0, 0}, {5, 0}, {5, 5}, {0, 5}});
    region.loops.push_back(outer.loops.front());
    Loop hole;
    hole.start = {23.25, 149.104143};
    for (const Vec2& to : {Vec2(23.172665, 149.240258), Vec2(22.94023, 149.952053), Vec2(23.25, 149.952052),
                           Vec2(23.25, 149.104143)})
        hole.segments.push_back({to, std::nullopt});
    region.loops.push_back(hole);
    ASSERT_FALSE(diagnose(region).has_value());
    const std::vector<Region> pieces = components(region);
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_NEAR(area(pieces[1]), area(outer) + signedArea(hole), 1e-12);
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

TEST(Region, TellsArcsOfMoreThanAHalfCircleByTheirSweep) {
    for (const bool ccw : {true, false})
        for (int from = 0; from < 12; ++from)
            for (int to = 0; to < 12; ++to)
                for (const double least_rad : {kPi, kPi + 1e-6, 1.5 * kPi}) {
                    const auto at = [](int hour) {
                        return snapToGrid(
                            Vec2(3 + 2 * std::cos(hour * kPi / 6), 2 * std::sin(hour * kPi / 6)));
                    };
                    const Arc arc{{3, 0}, 2, ccw};
                    EXPECT_EQ(planar::sweepsMoreThan(least_rad, at(from), at(to), arc),
                              std::abs(sweepAngle(at(from), at(to), arc)) > least_rad)
                        << from << " to " << to << ", " << least_rad;
                }
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
