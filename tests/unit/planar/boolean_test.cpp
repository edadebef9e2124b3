#include "stepmill/planar/boolean.h"

#include <gtest/gtest.h>

#include "stepmill/core/units.h"
#include "stepmill/planar/region_text.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

Region fromText(const std::string& text) {
    return regionFromText(text, "test");
}

int arcCount(const Region& region) {
    int count = 0;
    for (const Loop& loop : region.loops)
        for (const Segment& segment : loop.segments)
            count += segment.arc.has_value();
    return count;
}

std::size_t edgeCount(const Region& region) {
    std::size_t count = 0;
    for (const Loop& loop : region.loops)
        count += loop.segments.size();
    return count;
}

double totalLength(const std::vector<Path>& paths) {
    double sum = 0;
    for (const Path& path : paths)
        sum += length(path);
    return sum;
}

TEST(Boolean, AdjacentRectanglesUniteToOneWithFourEdges) {
    const Region whole = unite(makeRectangle({0, 0}, {3, 2}), makeRectangle({3, 0}, {5, 2}), kTol);
    EXPECT_EQ(toText(whole), "loop 0 0  line 5 0  line 5 2  line 0 2  close\n");
}

TEST(Boolean, WallsAFewNanometresApartAreOneWall) {
    const Region whole =
        unite(makeRectangle({0, 0}, {3, 2}), makeRectangle({3.000004, 0.000002}, {5, 2}), kTol);
    ASSERT_EQ(whole.loops.size(), 1u);
    EXPECT_NEAR(area(whole), 10, 1e-4);
    EXPECT_TRUE(
        subtract(makeRectangle({0, 0}, {3, 2}), makeRectangle({0.000003, 0}, {3.000002, 2}), kTol).empty());
}

TEST(Boolean, RegionMinusItselfIsEmpty) {
    for (const Region& region : {makeCircle({1, 2}, 3), makeRoundedRectangle({0, 0}, {20, 10}, 2.5),
                                 fromText("circle 0 0 radius 5 ccw\ncircle 0 0 radius 2 cw")}) {
        EXPECT_TRUE(subtract(region, region, kTol).empty());
        EXPECT_NEAR(area(intersect(region, region, kTol)), area(region), 1e-9);
        EXPECT_NEAR(area(unite(region, region, kTol)), area(region), 1e-9);
    }
}

TEST(Boolean, ArcPocketMinusTheSameWithOtherStartPointsIsEmpty) {
    const Region pocket = makeRoundedRectangle({0, 0}, {20, 10}, 2.5);
    Region other = pocket;
    Loop& loop = other.loops.front();
    std::rotate(loop.segments.begin(), loop.segments.begin() + 3, loop.segments.end());
    loop.start = loop.segments.back().to;
    EXPECT_TRUE(subtract(pocket, other, kTol).empty());
    // Corner arcs cut in two, and a circle that starts elsewhere.
    const Region circle{{Loop{{0, 3}, {{{0, 3}, Arc{{0, 0}, 3, true}}}}}};
    EXPECT_TRUE(subtract(makeCircle({0, 0}, 3), circle, kTol).empty());
    EXPECT_TRUE(subtract(circle, makeCircle({0, 0}, 3), kTol).empty());
}

TEST(Boolean, ConcentricCirclesMakeARing) {
    const Region ring = subtract(makeCircle({4, 4}, 3), makeCircle({4, 4}, 1), kTol);
    ASSERT_EQ(ring.loops.size(), 2u);
    EXPECT_NEAR(area(ring), 8 * kPi, 1e-9);
    EXPECT_EQ(arcCount(ring), 4);
    EXPECT_NEAR(area(unite(ring, makeCircle({4, 4}, 1), kTol)), 9 * kPi, 1e-9);
}

TEST(Boolean, CircleTangentToAWallFromInsideStaysAHoleThatTouches) {
    const Region plate = subtract(makeRectangle({0, 0}, {10, 10}), makeCircle({5, 2}, 2), kTol);
    EXPECT_NEAR(area(plate), 100 - 4 * kPi, 1e-6);
    EXPECT_EQ(plate.loops.size(), 2u);
    EXPECT_FALSE(diagnose(plate).has_value()) << *diagnose(plate);
    EXPECT_NEAR(area(intersect(makeRectangle({0, 0}, {10, 10}), makeCircle({5, 2}, 2), kTol)), 4 * kPi, 1e-6);
}

TEST(Boolean, CircleTangentFromOutsideAddsNothing) {
    const Region plate = makeRectangle({0, 0}, {10, 10});
    EXPECT_TRUE(intersect(plate, makeCircle({5, -2}, 2), kTol).empty());
    EXPECT_NEAR(area(subtract(plate, makeCircle({5, -2}, 2), kTol)), 100, 1e-9);
    EXPECT_EQ(unite(plate, makeCircle({5, -2}, 2), kTol).loops.size(), 2u);
}

TEST(Boolean, LensOfTwoCirclesHasTwoArcsAndTheKnownArea) {
    const Region lens = intersect(makeCircle({0, 0}, 5), makeCircle({6, 0}, 5), kTol);
    EXPECT_EQ(arcCount(lens), 2);
    EXPECT_EQ(edgeCount(lens), 2u);
    // 2 r^2 acos(d / 2r) - d/2 sqrt(4 r^2 - d^2)
    EXPECT_NEAR(area(lens), 50 * std::acos(0.6) - 24, 1e-5);
}

TEST(Boolean, JointsLieOnBothPrimitivesToANanometre) {
    const Region part = subtract(makeRectangle({0, 0}, {10, 10}), makeCircle({10, 10}, 3.7), kTol);
    ASSERT_EQ(arcCount(part), 1);
    for (const Segment& segment : part.loops.front().segments) {
        if (!segment.arc) continue;
        EXPECT_NEAR((segment.to - Vec2(10, 10)).norm(), 3.7, 1e-6);
    }
    EXPECT_FALSE(diagnose(part).has_value());
}

TEST(Boolean, SquaresTouchingAtACornerStayTwoLoops) {
    const Region both = unite(makeRectangle({0, 0}, {1, 1}), makeRectangle({1, 1}, {2, 2}), kTol);
    EXPECT_EQ(both.loops.size(), 2u);
    EXPECT_FALSE(diagnose(both).has_value());
}

TEST(Boolean, IslandsInHolesAreHandled) {
    const Region plate = fromText(
        "loop 0 0 line 20 0 line 20 20 line 0 20 close\n"
        "loop 5 5 line 5 15 line 15 15 line 15 5 close\n"
        "circle 10 10 radius 2 ccw\n");
    const Region rest = subtract(makeRectangle({-1, -1}, {21, 21}), plate, kTol);
    EXPECT_NEAR(area(rest), 22 * 22 - area(plate), 1e-6);
    EXPECT_EQ(components(rest).size(), 2u);
    EXPECT_NEAR(area(unite(rest, plate, kTol)), 22 * 22, 1e-6);
}

TEST(Boolean, EmptyOperandsAndDistantBoxes) {
    const Region square = makeRectangle({0, 0}, {1, 1});
    const Region far = makeRectangle({5, 5}, {6, 6});
    EXPECT_TRUE(intersect(square, Region{}, kTol).empty());
    EXPECT_TRUE(intersect(square, far, kTol).empty());
    EXPECT_TRUE(subtract(Region{}, square, kTol).empty());
    EXPECT_EQ(toText(subtract(square, far, kTol)), toText(square));
    EXPECT_EQ(toText(unite(square, Region{}, kTol)), toText(square));
    EXPECT_TRUE(unite(std::span<const Region>(), kTol).empty());
}

TEST(Boolean, ManyOverlappingRegionsUniteAtOnce) {
    std::vector<Region> row;
    for (int i = 0; i < 50; ++i)
        row.push_back(makeRectangle({i * 1.0, 0}, {i * 1.0 + 1.5, 2}));
    EXPECT_EQ(toText(unite(row, kTol)), "loop 0 0  line 50.5 0  line 50.5 2  line 0 2  close\n");
}

TEST(Boolean, LoopsStartAtTheirLowestLeftmostVertexInThatOrder) {
    const Region both = unite(makeRectangle({5, 5}, {6, 6}), makeCircle({0, 0}, 1), kTol);
    EXPECT_EQ(toText(both), "circle 0 0 radius 1 ccw\nloop 5 5  line 6 5  line 6 6  line 5 6  close\n");
}

TEST(Boolean, SliverBetweenNearlyEqualWallsVanishes) {
    const Region a = makeRectangle({0, 0}, {50, 20});
    const Region b = makeRectangle({0, 0}, {50, 20.00009});
    EXPECT_TRUE(subtract(b, a, kTol).empty());
    EXPECT_NEAR(area(subtract(makeRectangle({0, 0}, {50, 20.001}), a, kTol)), 0.05, 1e-6);
}

TEST(Boolean, PartsOfARegionJoinWithoutASpikeWhereTheyMet) {
    const Region whole = makePolygon({{30, 15}, {45, 15}, {30, 30}});
    const Region band = makeRectangle({24.999921, 20.000003}, {34.999921, 25.000003});
    const Region parts[] = {subtract(whole, band, kTol), intersect(whole, band, kTol)};
    const Region again = unite(parts, kTol);
    EXPECT_NEAR(area(again), area(whole), 1e-4);
    EXPECT_FALSE(diagnose(again).has_value()) << toText(again);
}

TEST(Split, CutsALineIntoInsideOnAndOutside) {
    const Region region = makeRectangle({0, 0}, {10, 10});
    const Path path{{-5, 0}, {{{5, 0}, {}}, {{5, 5}, {}}, {{15, 5}, {}}}};
    const SplitPath parts = split(path, region, kTol);
    EXPECT_NEAR(totalLength(parts.on), 5, 1e-9);
    EXPECT_NEAR(totalLength(parts.inside), 10, 1e-9);
    EXPECT_NEAR(totalLength(parts.outside), 10, 1e-9);
    ASSERT_EQ(parts.inside.size(), 1u);
    EXPECT_EQ(parts.inside[0].segments.size(), 2u);
}

TEST(Split, KeepsArcsAndJoinsAcrossTheStartOfAClosedPath) {
    const Path circle{{5, 0}, {{{5, 0}, Arc{{0, 0}, 5, true}}}};
    const SplitPath parts = split(circle, makeRectangle({0, -10}, {10, 10}), kTol);
    ASSERT_EQ(parts.inside.size(), 1u);
    ASSERT_EQ(parts.outside.size(), 1u);
    EXPECT_EQ(parts.inside[0].start, Vec2(0, -5));
    EXPECT_EQ(parts.inside[0].end(), Vec2(0, 5));
    EXPECT_NEAR(length(parts.inside[0]), 5 * kPi, 1e-6);
    EXPECT_TRUE(parts.outside[0].segments[0].arc.has_value());
}

TEST(Split, BoundaryOfTheRegionItselfIsAllOn) {
    const Region region = makeRoundedRectangle({0, 0}, {20, 10}, 3);
    const SplitPath parts = split(region.loops.front(), region, kTol);
    ASSERT_EQ(parts.on.size(), 1u);
    EXPECT_TRUE(parts.on[0].closed());
    EXPECT_TRUE(parts.inside.empty());
    EXPECT_TRUE(parts.outside.empty());
}

TEST(Split, TangentTouchDoesNotCut) {
    const SplitPath parts = split(Path{{-10, 2}, {{{10, 2}, {}}}}, makeCircle({0, 0}, 2), kTol);
    EXPECT_TRUE(parts.inside.empty());
    ASSERT_EQ(parts.outside.size(), 1u);
    EXPECT_EQ(parts.outside[0].segments.size(), 1u);
}

TEST(Covers, AllowsThinStripsOnly) {
    const Region outer = makeRectangle({0, 0}, {10, 10});
    EXPECT_TRUE(covers(outer, makeRectangle({1, 1}, {9, 9}), 0.001, kTol));
    EXPECT_TRUE(covers(outer, makeRectangle({0, 0}, {10.0005, 10}), 0.001, kTol));
    EXPECT_FALSE(covers(outer, makeRectangle({0, 0}, {10.5, 10}), 0.001, kTol));
    EXPECT_FALSE(covers(Region{}, outer, 0.001, kTol));
}

}  // namespace
}  // namespace stepmill
