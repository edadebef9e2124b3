// Openings, their areas and what they leave to a smaller cutter, on shapes one can work out by hand.

#include <gtest/gtest.h>

#include <cmath>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/region_text.h"
#include "support/tolerances.h"
#include "unit/planar/clearance_shapes.h"

namespace stepmill {
namespace {

using test::addHole;
using test::arcCount;
using test::expectArea;
using test::expectRoundedArea;
using test::pocketWithIsland;
using test::roundedArea;

using test::kTol;
const double kSharpCorner = 1 - kPi / 4;  ///< what a disc of radius 1 leaves in a square corner

Segment line(double x, double y) {
    return {{x, y}, std::nullopt};
}

Segment arc(double x, double y, const Vec2& centre, bool ccw) {
    return {{x, y}, Arc{centre, (Vec2(x, y) - centre).norm(), ccw}};
}

TEST(ClearanceOpening, OpeningWithSmallerOrEqualCutterGivesTheRegionBack) {
    const Region region = pocketWithIsland();
    const ClearanceDiagram diagram(region, kTol);
    for (double r : {0.5, 3.0, 6.0}) {
        const Region opened = diagram.opening(r);
        expectArea(opened, area(region));
        EXPECT_EQ(arcCount(opened), arcCount(region));
    }
    const double left_in_corners = (4 - kPi) * (8 * 8 - 6 * 6);
    expectArea(diagram.opening(8), area(region) - left_in_corners);
}

constexpr double kStripMm = 2e-3;

TEST(ClearanceStrips, ARegionWithoutAnyIsTheSameToTheVertex) {
    const Region region = pocketWithIsland();
    EXPECT_EQ(toText(ClearanceDiagram(region, kTol).withoutStrips(kStripMm)), toText(region));
}

TEST(ClearanceStrips, AreCutStraightAtTheWallTheyHangOn) {
    const double thin = 0.7 * kStripMm;
    const Region flag =
        makePolygon({{0, 0}, {10, 0}, {10, 5 - thin}, {30, 5 - thin}, {30, 5}, {10, 5}, {0, 5}});
    const Region kept = ClearanceDiagram(flag, kTol).withoutStrips(kStripMm);
    EXPECT_EQ(arcCount(kept), 0) << "an opening would round the corners";
    EXPECT_NEAR(boundingBox(kept).max().x(), 10, kStripMm);
    EXPECT_NEAR(area(kept), 50, 10 * kStripMm);
    EXPECT_LE(area(subtract(kept, flag, kTol)), 1e-6);
}

TEST(ClearanceStrips, BetweenTwoPiecesPartThem) {
    const double thin = 0.7 * kStripMm;
    const Region dumbbell = makePolygon({{0, 0},
                                         {10, 0},
                                         {10, 5},
                                         {20, 5},
                                         {20, 0},
                                         {30, 0},
                                         {30, 10},
                                         {20, 10},
                                         {20, 5 + thin},
                                         {10, 5 + thin},
                                         {10, 10},
                                         {0, 10}});
    const Region kept = ClearanceDiagram(dumbbell, kTol).withoutStrips(kStripMm);
    EXPECT_EQ(components(kept).size(), 2u);
    EXPECT_NEAR(area(kept), 200, 10 * kStripMm);
}

TEST(ClearanceOpening, DiscsOnBothSidesOfANeckUnite) {
    const std::vector<Vec2> hourglass{{-10, -10}, {0, -1}, {10, -10}, {10, 10}, {0, 1}, {-10, 10}};
    const ClearanceDiagram diagram(makePolygon(hourglass), kTol);
    EXPECT_EQ(components(diagram.offset(-1.2)).size(), 2u);
    const Region opened = diagram.opening(1.2);
    EXPECT_FALSE(diagnose(opened));
    EXPECT_EQ(components(opened).size(), 1u) << "the discs of both sides overlap in the neck";
}

TEST(ClearanceOpening, ClosesTheFarSideOfAnIslandThatStandsNearerToTheOtherWall) {
    // Discs at both ends of the island's lower half meet the upper wall, 4.3 mm away; below it are 3.2 mm.
    const Region slot = subtract(makeRectangle({0, 0}, {62, 10}), makeCircle({14, 5.7}, 2.5), kTol);
    const ClearanceDiagram diagram(slot, kTol);
    EXPECT_TRUE(contains(diagram.opening(1.59), {14, 1.6}));
    for (const double r : {2.0, 3.0}) {
        const Region opened = diagram.opening(r);
        EXPECT_FALSE(contains(opened, {14, 1.6})) << r;
        // Booleans move shared walls by up to 0.1 um.
        EXPECT_NEAR(area(opened), area(intersect(offset(offset(slot, -r, kTol), r, kTol), slot, kTol)), 1e-4);
    }
}

TEST(ClearanceOpening, OfARectangleRoundsItsCorners) {
    const ClearanceDiagram diagram(makeRectangle({0, 0}, {20, 10}), kTol);
    for (const double r : {0.001, 1.0, 3.25, 4.999}) {
        expectArea(diagram.opening(r), roundedArea(20, 10, r));
        EXPECT_NEAR(diagram.accessibleArea(r), roundedArea(20, 10, r), 2e-7);
        EXPECT_EQ(arcCount(diagram.opening(r)), 4);
    }
    EXPECT_TRUE(diagram.opening(5).empty()) << "the rectangle is a neck all along";
    EXPECT_EQ(diagram.accessibleArea(5), 0);
}

TEST(ClearanceOpening, OfAStadiumIsTheStadium) {
    const Region stadium = makeRoundedRectangle({0, 0}, {30, 8}, 4);
    const ClearanceDiagram diagram(stadium, kTol);
    for (const double r : {0.5, 2.0, 3.9, 3.9998})
        expectArea(diagram.opening(r), roundedArea(30, 8, 4));
    EXPECT_TRUE(diagram.opening(4.001).empty());
}

TEST(ClearanceOpening, OfAnAnnulusIsTheAnnulusUntilItIsTooNarrow) {
    Region ring = makeCircle({1, 2}, 5);
    addHole(ring, makeCircle({1, 2}, 2));
    const ClearanceDiagram diagram(ring, kTol);
    for (const double r : {0.1, 1.0, 1.4999})
        expectArea(diagram.opening(r), kPi * (25 - 4));
    EXPECT_TRUE(diagram.opening(1.5001).empty());
    EXPECT_NEAR(diagram.accessibleArea(1.25), kPi * 21, 1e-9 * kPi * 21);
}

TEST(ClearanceOpening, OfAnEccentricRingLeavesItsNarrowSide) {
    const Region ring = test::eccentricRing();
    const ClearanceDiagram diagram(ring, kTol);
    expectArea(diagram.opening(0.999), kPi * (17 * 17 - 11 * 11));
    // A disc of radius 2 stops at (9, +-12), where it touches the circles at (10.2, 13.6) and along (5, 12).
    const double x = 4 + 5 * 11.0 / 13;
    const double y = 12 * 11.0 / 13;
    const Loop unswept{{10.2, -13.6},
                       {arc(10.2, 13.6, {0, 0}, true), arc(x, y, {9, 12}, false), arc(x, -y, {4, 0}, false),
                        arc(10.2, -13.6, {9, -12}, false)}};
    const double expected = kPi * (17 * 17 - 11 * 11) - signedArea(unswept);
    expectRoundedArea(diagram.opening(2), expected, 20);
    EXPECT_EQ(diagram.accessibleArea(2), area(diagram.opening(2)));
    EXPECT_EQ(arcCount(diagram.opening(2)), 6)
        << "both circles in two halves: " << toText(diagram.opening(2));
    EXPECT_TRUE(diagram.opening(5.0001).empty());
}

TEST(ClearanceOpening, AtTheVeryTieOfAnEccentricRing) {
    const Region crescent = regionFromText("circle 2 0 radius 9 ccw\ncircle 0 0 radius 3 cw", "crescent");
    const ClearanceDiagram diagram(crescent, kTol);
    EXPECT_EQ(diagnose(diagram.opening(2)), std::nullopt);
    // Equal is not passable: the neck's disc is not swept, but all up to it is.
    expectRoundedArea(diagram.opening(2), kPi * (81 - 9), 100);
    expectArea(diagram.opening(1.999), kPi * (81 - 9));
    expectRoundedArea(diagram.offset(-2), kPi * (49 - 25), 100);
    EXPECT_EQ(diagnose(diagram.offset(-2)), std::nullopt);
}

TEST(ClearanceOpening, OfAnEllLeavesItsArmsToSmallerCutters) {
    const ClearanceDiagram diagram(makePolygon({{0, 0}, {20, 0}, {20, 8}, {8, 8}, {8, 20}, {0, 20}}), kTol);
    expectArea(diagram.opening(2), 256 - 5 * kSharpCorner * 4);
    expectArea(diagram.opening(3.999), 256 - 5 * kSharpCorner * 3.999 * 3.999);
    // Only the bend holds a disc of radius 4.5; it stops where it touches a wall and the inner corner.
    const double stop = 8 - std::sqrt(4.5 * 4.5 - 3.5 * 3.5);
    const Loop bend{{4.5, 0},
                    {line(stop, 0), arc(8, 8, {stop, 4.5}, true), arc(0, stop, {4.5, stop}, true),
                     line(0, 4.5), arc(4.5, 0, {4.5, 4.5}, true)}};
    expectRoundedArea(diagram.opening(4.5), signedArea(bend), 20);
    EXPECT_EQ(diagram.accessibleArea(4.5), area(diagram.opening(4.5)));
    const double widest = 8 * std::sqrt(2.0) / (1 + std::sqrt(2.0));
    ASSERT_TRUE(diagram.largestInscribedDisc());
    EXPECT_NEAR(diagram.largestInscribedDisc()->radius_mm, widest, 1e-9);
    EXPECT_FALSE(diagram.opening(widest - 1e-3).empty());
    EXPECT_TRUE(diagram.opening(widest + 1e-3).empty());
}

// Found by the fuzzer: a corner that stands on a wall leaves no level at the very radius. The discs then
// stand at one a hair larger, and so must the arcs they leave.
TEST(ClearanceOpening, IsValidBesideACornerThatTouchesAWall) {
    const ClearanceDiagram diagram(makePolygon({{0, 0},
                                                {30, 0},
                                                {30, 11},
                                                {50, 11},
                                                {52, 5},
                                                {70, 5},
                                                {70, 25},
                                                {50, 25},
                                                {50, 19},
                                                {21, 19},
                                                {30, 2},
                                                {0, 30}}),
                                   kTol);
    ASSERT_TRUE(diagram.largestInscribedDisc());
    for (const double share : {0.2, 0.5, 0.9}) {
        const Region opened = diagram.opening(share * diagram.largestInscribedDisc()->radius_mm);
        EXPECT_EQ(diagnose(opened), std::nullopt) << share;
        EXPECT_FALSE(opened.empty()) << share;
    }
}

TEST(ClearanceOpening, OfACrossIsItsMiddleForCuttersWiderThanTheArms) {
    const ClearanceDiagram diagram(test::cross(), kTol);
    expectArea(diagram.opening(3), 2 * 32 * 8 - 64 - 8 * kSharpCorner * 9);
    // Four discs of radius 5 about (+-1, 0) and (0, +-1) overlap and touch the four inner corners.
    const Loop middle{{4, -4},
                      {arc(4, 4, {1, 0}, true), arc(-4, 4, {0, 1}, true), arc(-4, -4, {-1, 0}, true),
                       arc(4, -4, {0, -1}, true)}};
    expectArea(diagram.opening(5), signedArea(middle));
    EXPECT_NEAR(diagram.accessibleArea(5), signedArea(middle), 1e-9 * signedArea(middle));
    EXPECT_NEAR(diagram.largestInscribedDisc()->radius_mm, std::sqrt(32.0), 1e-9);
}

TEST(ClearanceOpening, OfADogBoneReachesIntoTheNeck) {
    const ClearanceDiagram diagram(test::dogBone(), kTol);
    expectArea(diagram.opening(2), 2 * 400 + 60 - 8 * kSharpCorner * 4);
    // A disc of radius 5 stops between the corners of the neck, 4 before it.
    const double reach = 25 * std::asin(0.6) - 12;
    const double rooms = 2 * (400 - 4 * kSharpCorner * 25 + reach);
    expectArea(diagram.opening(5), rooms);
    EXPECT_NEAR(diagram.accessibleArea(5), rooms, 1e-9 * rooms);
    EXPECT_EQ(components(diagram.opening(5)).size(), 2u);
    // The tie: the neck is not passable, its ends are half discs. One nanometre of radius moves the discs of
    // both ends, 6 wide, by sqrt(2 * 3 * 1e-6).
    const double tie = 2 * (400 - 4 * kSharpCorner * 9 + kPi * 9 / 2);
    EXPECT_NEAR(area(diagram.opening(3)), tie, 2 * 6 * std::sqrt(6e-6));
}

TEST(ClearanceOpening, GoesOnWhereAChamferVanishes) {
    const double side = 2;
    const double length = side * std::sqrt(2.0);
    const double turn = std::tan(kPi / 8);
    const double vanishes = length / (2 * turn);
    const ClearanceDiagram diagram(test::chamfered(side), kTol);
    for (const double r : {1.0, 3.0, vanishes - 1e-3, vanishes + 1e-3, 4.0, 4.9}) {
        const double whole = 200 - side * side / 2;
        const double beside =
            r < vanishes ? 2 * (turn - kPi / 8) * r * r : kSharpCorner * r * r - side * side / 2;
        const double expected = whole - 3 * kSharpCorner * r * r - beside;
        expectRoundedArea(diagram.opening(r), expected, 10);
        EXPECT_EQ(diagram.accessibleArea(r), area(diagram.opening(r))) << r;
    }
}

TEST(ClearanceOpening, ThreeRoomsRoundATriangleOverlapInTheMiddle) {
    // Discs of radius 4 from all three rooms stop at the island's corners and lie over each other beside it.
    const Region rooms = unite(std::vector<Region>{makeCircle({6, 0}, 5), makeCircle({-3, 5.196152}, 5),
                                                   makeCircle({-3, -5.196152}, 5)},
                               kTol);
    const Region region =
        subtract(rooms, makePolygon({{-0.5, 0}, {0.25, 0.433013}, {0.25, -0.433013}}), kTol);
    const ClearanceDiagram diagram(region, kTol);
    for (const double r : {0.5, 1.5, 2.0, 2.5, 3.0, 4.0, 4.9}) {
        const Region opened = diagram.opening(r);
        EXPECT_EQ(diagnose(opened), std::nullopt) << r;
        const Region centres = diagram.offset(-r);
        EXPECT_NEAR(area(opened), area(offset(centres, r, kTol)), 1e-5) << r;
        EXPECT_NEAR(diagram.accessibleArea(r), area(opened), 1e-5) << r;
    }
}

/// Rest regions end in tips of no width where the larger disc leaves the wall; they are cut at 10 nm.
constexpr double kTipsMm2 = 1e-6;

TEST(ClearanceRest, OfARectangleAreItsCorners) {
    const ClearanceDiagram diagram(makeRectangle({0, 0}, {20, 10}), kTol);
    const Region rest = diagram.restCentres(3, 1);
    EXPECT_EQ(components(rest).size(), 4u);
    EXPECT_NEAR(area(rest), 4 * kSharpCorner * 2 * 2, kTipsMm2);
    EXPECT_EQ(diagnose(rest), std::nullopt);
    // A cutter that fits nowhere leaves everything.
    expectArea(diagram.restCentres(6, 1), 18 * 8);
}

TEST(ClearanceRest, IsEmptyWhereBothCuttersReachTheSame) {
    const ClearanceDiagram pocket(pocketWithIsland(), kTol);
    EXPECT_TRUE(pocket.restCentres(6, 3).empty()) << "fillets of their own radius are filled";
    EXPECT_TRUE(pocket.restCentres(5, 0.5).empty());
    EXPECT_TRUE(pocket.restCentres(7, 7).empty());
    EXPECT_NEAR(area(pocket.restCentres(8, 3)), 4 * kSharpCorner * (25 - 9), kTipsMm2);
    const ClearanceDiagram ring(test::eccentricRing(), kTol);
    EXPECT_TRUE(ring.restCentres(0.99, 0.2).empty());
    EXPECT_FALSE(ring.restCentres(2, 0.9).empty());
}

TEST(ClearanceRest, IsEmptyInTheRoomThatBothReachAlike) {
    Region both = makeRoundedRectangle({0, 0}, {20, 20}, 5);
    both.loops.push_back(makeRectangle({30, 0}, {50, 20}).loops.front());
    const Region rest = ClearanceDiagram(both, kTol).restCentres(4, 2);
    EXPECT_EQ(components(rest).size(), 4u);
    EXPECT_GT(boundingBox(rest).min().x(), 30);
    EXPECT_NEAR(area(rest), 4 * kSharpCorner * 4, kTipsMm2);
}

TEST(ClearanceRest, TogetherWithTheLargeCutterSweepsAll) {
    for (const Region& region : {pocketWithIsland(), test::dogBone(), test::cross(), test::eccentricRing()}) {
        const ClearanceDiagram diagram(region, kTol);
        for (const double large : {2.0, 3.0, 5.0, 8.0}) {
            const Region rest = offset(diagram.restCentres(large, 1), 1, kTol);
            const Region all = unite(diagram.opening(large), rest, kTol);
            EXPECT_NEAR(area(all), area(diagram.opening(1)), 1e-6 * area(region)) << large;
        }
    }
}

}  // namespace
}  // namespace stepmill
