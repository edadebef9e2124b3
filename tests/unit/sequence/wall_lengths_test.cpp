#include "sequence/dag/wall_lengths.h"

#include <cmath>

#include <gtest/gtest.h>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "support/sample_feature.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

WallLength touchedIn(const Feature& feature, double radius_mm) {
    CutterArea cutter;
    cutter.radius_mm = radius_mm;
    cutter.free_centres = offset(feature.target, -radius_mm, kTol);
    return Walls(feature, kTol).touchedBy(cutter);
}

/// Of wall that is left at both ends of so many stretches.
double atEnds(int stretches, double radius_mm) {
    return stretches * 2 * std::sqrt(2 * radius_mm * kTol.sliver_mm);
}

TEST(WallLengths, OfStraightWallsEndARadiusOffSharpCorners) {
    const Feature pocket = makePocket(makeRectangle({0, 0}, {60, 40}), 10);
    const WallLength touched = touchedIn(pocket, 5);
    const double straight_mm = 2 * (60 - 10) + 2 * (40 - 10);
    EXPECT_NEAR(touched.least_mm, straight_mm - atEnds(4, 5), 0.05);
    EXPECT_NEAR(touched.most_mm, straight_mm + atEnds(4, 5), 0.05);
    EXPECT_LE(touched.least_mm, straight_mm);
    EXPECT_GE(touched.most_mm, straight_mm);
    EXPECT_EQ(touched.hollow_least_mm, 0);
}

TEST(WallLengths, OfHollowArcsAreTheCentresWay) {
    const Feature pocket = makePocket(makeCircle({0, 0}, 20), 10);
    const WallLength touched = touchedIn(pocket, 5);
    EXPECT_EQ(touched.least_mm, 0);
    EXPECT_EQ(touched.most_mm, 0);
    EXPECT_NEAR(touched.hollow_least_mm, 2 * kPi * 15 - atEnds(2, 5), 0.05);
    EXPECT_EQ(touchedIn(pocket, 20.5).hollow_least_mm, 0);
}

TEST(WallLengths, OfIslandsAreTheirOwn) {
    const Region around = subtract(makeRectangle({0, 0}, {60, 60}), makeCircle({30, 30}, 10), kTol);
    const WallLength touched = touchedIn(makePocket(around, 10), 5);
    const double walls_mm = 4 * (60 - 10) + 2 * kPi * 10;
    EXPECT_NEAR(touched.least_mm, walls_mm - atEnds(6, 5), 0.5);
    EXPECT_LE(touched.least_mm, walls_mm);
    EXPECT_GE(touched.most_mm, walls_mm);
}

TEST(WallLengths, OfOpenSidesAreNone) {
    Feature slot = makePocket(makeRectangle({0, 0}, {60, 40}), 10);
    slot.obstruction = makeRectangle({-20, 40}, {80, 60});
    CutterArea cutter;
    cutter.radius_mm = 5;
    cutter.free_centres = makeRectangle({-10, -10}, {70, 35});
    const WallLength touched = Walls(slot, kTol).touchedBy(cutter);
    EXPECT_NEAR(touched.least_mm, 60 - atEnds(1, 5), 0.05);
}

TEST(WallLengths, OfSlotsAsWideAsTheCutterAreNotSure) {
    const Feature slot = makePocket(makeRectangle({0, 0}, {60, 10}), 10);
    CutterArea cutter;
    cutter.radius_mm = 5;
    cutter.free_centres = makeRectangle({5, 4.999}, {55, 5.001});
    cutter.slot_middles.push_back(Path{{5, 5}, {{{55, 5}, std::nullopt}}});
    const WallLength touched = Walls(slot, kTol).touchedBy(cutter);
    EXPECT_EQ(touched.least_mm, 0);
    EXPECT_GE(touched.most_mm, 100);
}

}  // namespace
}  // namespace stepmill::test
