#include "stepmill/planar/clearance_diagram.h"

#include <gtest/gtest.h>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/region_text.h"
#include "support/tolerances.h"
#include "unit/planar/clearance_shapes.h"

namespace stepmill {
namespace {

using test::addHole;
using test::arcCount;
using test::expectArea;
using test::pocketWithIsland;
using test::roundedArea;

using test::kTol;

TEST(ClearanceDiagram, RoundedPocketWithIslandShrinksAndGrowsExactly) {
    const ClearanceDiagram diagram(pocketWithIsland(), kTol);
    for (double d : {0.001, 1.0, 3.0, 5.999, 6.0, 6.001, 7.5, 8.4}) {
        const double corner = std::max(0.0, 6 - d);
        const double island = kPi * (8 + d) * (8 + d);
        expectArea(diagram.offset(-d), roundedArea(70 - 2 * d, 50 - 2 * d, corner) - island);
        EXPECT_FALSE(diagnose(diagram.offset(-d)));
    }
    for (double d : {1.0, 5.0, 7.999}) {
        expectArea(diagram.offset(d), roundedArea(70 + 2 * d, 50 + 2 * d, 6 + d) - kPi * (8 - d) * (8 - d));
    }
    expectArea(diagram.offset(8), roundedArea(86, 66, 14));
}

TEST(ClearanceDiagram, ArcsStayArcs) {
    const ClearanceDiagram diagram(pocketWithIsland(), kTol);
    EXPECT_EQ(arcCount(diagram.offset(-3)), 4 + 2);
    EXPECT_EQ(arcCount(diagram.offset(-6)), 2);
    EXPECT_EQ(diagram.offset(-6).loops[0].segments.size() + diagram.offset(-6).loops[1].segments.size(), 6u);
    EXPECT_EQ(arcCount(diagram.offset(3)), 4 + 2);
}

TEST(ClearanceDiagram, SharpCornersShrinkSharpAndGrowRound) {
    const ClearanceDiagram diagram(makeRectangle({0, 0}, {20, 10}), kTol);
    expectArea(diagram.offset(-2), 16 * 6);
    expectArea(diagram.offset(3), roundedArea(26, 16, 3));
    expectArea(diagram.opening(2), roundedArea(20, 10, 2));
    EXPECT_TRUE(diagram.offset(-5).empty());
}

TEST(ClearanceDiagram, CircleAndAnnulus) {
    const Region disc = makeCircle({1, 2}, 5);
    expectArea(offset(disc, -2, kTol), kPi * 9);
    expectArea(offset(disc, 2, kTol), kPi * 49);
    EXPECT_TRUE(offset(disc, -5, kTol).empty());
    Region ring = disc;
    addHole(ring, makeCircle({1, 2}, 2));
    expectArea(offset(ring, -1, kTol), kPi * (16 - 9));
    expectArea(offset(ring, 1, kTol), kPi * (36 - 1));
    expectArea(offset(ring, 2, kTol), kPi * 49);
    EXPECT_TRUE(offset(ring, -1.5, kTol).empty());
}

TEST(ClearanceDiagram, EccentricAnnulusOpensAtItsNarrowSide) {
    Region ring = makeCircle({0, 0}, 10);
    addHole(ring, makeCircle({3, 0}, 5));
    const ClearanceDiagram diagram(ring, kTol);
    EXPECT_EQ(diagram.offset(-0.9).loops.size(), 2u);
    EXPECT_EQ(diagram.offset(-1).loops.size(), 1u);
    EXPECT_EQ(diagram.offset(-3.9).loops.size(), 1u);
    EXPECT_TRUE(diagram.offset(-4).empty());
    ASSERT_TRUE(diagram.largestInscribedDisc());
    EXPECT_NEAR(diagram.largestInscribedDisc()->radius_mm, 4, 1e-9);
}

TEST(ClearanceDiagram, SlotIsPassableOnlyForNarrowerCutters) {
    const ClearanceDiagram slot(makeRoundedRectangle({0, 0}, {30, 8}, 4), kTol);
    EXPECT_TRUE(slot.offset(-4).empty());
    expectArea(slot.offset(-3), 22 * 2 + kPi);
    expectArea(slot.opening(3.9), roundedArea(30, 8, 4));
}

TEST(ClearanceDiagram, NeckOfExactlyTheCutterWidthIsClosed) {
    const std::vector<Vec2> dumbbell{{0, 0},   {10, 0},  {10, 4}, {20, 4}, {20, 0},  {30, 0},
                                     {30, 10}, {20, 10}, {20, 6}, {10, 6}, {10, 10}, {0, 10}};
    const ClearanceDiagram diagram(makePolygon(dumbbell), kTol);
    EXPECT_EQ(components(diagram.offset(-0.999)).size(), 1u);
    EXPECT_EQ(components(diagram.offset(-1)).size(), 2u);
    EXPECT_EQ(components(diagram.offset(-0.99996)).size(), 1u);
    EXPECT_EQ(components(diagram.offset(-0.999999)).size(), 2u) << "within the tolerance of a tie";
    EXPECT_EQ(components(diagram.opening(2)).size(), 2u);
}

TEST(ClearanceDiagram, GapOfExactlyTwiceTheGrowthCloses) {
    Region pair = makeRectangle({0, 0}, {10, 10});
    const Region right = makeRectangle({14, 0}, {24, 10});
    pair.loops.push_back(right.loops[0]);
    const ClearanceDiagram diagram(pair, kTol);
    EXPECT_EQ(components(diagram.offset(1.999)).size(), 2u);
    EXPECT_EQ(components(diagram.offset(2)).size(), 1u);
}

TEST(ClearanceDiagram, ReflexCornerOffsetsToAnArc) {
    const Region ell = makePolygon({{0, 0}, {20, 0}, {20, 8}, {8, 8}, {8, 20}, {0, 20}});
    const Region shrunk = offset(ell, -2, kTol);
    EXPECT_EQ(arcCount(shrunk), 1);
    // Two strips of 4 x 16 that share a square; the reflex corner's arc bulges into that square's corner.
    expectArea(shrunk, 2 * 4 * 16 - 16 + (4 - kPi));
}

TEST(ClearanceDiagram, LargeAndTinyPartsAreAsExact) {
    for (double scale : {1e-3, 1.0, 25.0}) {
        const Region region = makeRoundedRectangle({0, 0}, scale * Vec2(70, 50), scale * 6);
        expectArea(offset(region, -scale * 2, kTol), scale * scale * roundedArea(66, 46, 4));
        expectArea(offset(region, scale * 2, kTol), scale * scale * roundedArea(74, 54, 8));
    }
}

TEST(ClearanceDiagram, GrowthFarBeyondTheRegionWorks) {
    const Region square = makeRectangle({0, 0}, {10, 10});
    expectArea(offset(square, 2000, kTol), 100 + 40 * 2000.0 + kPi * 4e6);
}

TEST(ClearanceDiagram, RingsAreNestedAndEnd) {
    const ClearanceDiagram diagram(pocketWithIsland(), kTol);
    const std::vector<Region> rings = diagram.rings(1, 1.5);
    ASSERT_GT(rings.size(), 5u);
    for (std::size_t k = 1; k < rings.size(); ++k)
        EXPECT_TRUE(covers(rings[k - 1], rings[k], 1e-6, kTol));
    EXPECT_TRUE(diagram.offset(-(1 + 1.5 * static_cast<double>(rings.size()))).empty());
}

TEST(ClearanceDiagram, HolesThatTouchEachOtherAndTheWall) {
    Region plate = makeRectangle({0, 0}, {40, 20});
    addHole(plate, makeCircle({15, 10}, 5));
    addHole(plate, makeCircle({25, 10}, 5));
    const Region shrunk = offset(plate, -1, kTol);
    EXPECT_FALSE(diagnose(shrunk));
    // Two discs of radius 6, 10 mm apart, overlap in a lens.
    const double lens = 2 * 36 * std::acos(5.0 / 6) - 10 * std::sqrt(36.0 - 25);
    // The lens' corners are rounded to the grid, and 60 mm of arcs hang on them.
    EXPECT_NEAR(area(shrunk), 38 * 18 - 2 * kPi * 36 + lens, 60 * kGridMm / 10);
}

TEST(ClearanceDiagram, AnswersAlikeHoweverOftenAndInWhateverOrderItIsAsked) {
    Region plate = makeRectangle({0, 0}, {40, 20});
    addHole(plate, makeCircle({15, 10}, 5));
    addHole(plate, makeCircle({25, 10}, 5));
    const ClearanceDiagram diagram(plate, kTol);
    for (int time = 0; time < 2; ++time)
        for (const double distance_mm : {1.0, -1.0, -2.0, 2.0}) {
            const Region alone = offset(plate, distance_mm, kTol);
            EXPECT_EQ(toText(diagram.offset(distance_mm)), toText(alone)) << distance_mm;
        }
}

TEST(ClearanceDiagram, EmptyRegionStaysEmpty) {
    const ClearanceDiagram diagram(Region{}, kTol);
    EXPECT_TRUE(diagram.offset(5).empty());
    EXPECT_TRUE(diagram.offset(-5).empty());
    EXPECT_TRUE(diagram.opening(1).empty());
    EXPECT_FALSE(diagram.largestInscribedDisc());
}

TEST(ClearanceDiagram, LargestDiscOfARectangleTouchesBothLongSides) {
    const auto disc = ClearanceDiagram(makeRectangle({0, 0}, {30, 10}), kTol).largestInscribedDisc();
    ASSERT_TRUE(disc);
    EXPECT_NEAR(disc->radius_mm, 5, 1e-9);
    EXPECT_NEAR(disc->centre.y(), 5, 1e-9);
}

}  // namespace
}  // namespace stepmill
