#include <gtest/gtest.h>

#include "stepmill/access/slivers.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "support/grounds.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::closedPocket;
using test::endMill;
using test::kMaterial;
using test::makeFeature;

using test::kTol;

CutterArea access(const FeatureGround& ground, double diameter_mm) {
    return toolReach(ground, endMill(diameter_mm), kMaterial).cutter;
}

Region islandPocket() {
    return subtract(makeRoundedRectangle({0, 0}, {70, 50}, 6), makeCircle({35, 25}, 8), kTol);
}

/// A_n n T without A_m u D_mn: what eq. 2 of [DSouza2006] says is nothing.
double missed(const CutterArea& m, const CutterArea& n, const DecomposedArea& d) {
    const Region both = unite(m.accessible, d.area, kTol);
    return area(access::withoutSliverComponents(subtract(n.coverable, both, kTol), kTol));
}

TEST(DecomposedArea, OfAFirstToolIsWhatItReaches) {
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    const CutterArea n = access(ground, 10);
    const DecomposedArea d = decomposedArea(ground, nullptr, n);
    EXPECT_DOUBLE_EQ(area(d.area), area(n.accessible));
    EXPECT_DOUBLE_EQ(area(d.centres), area(n.free_centres));
    EXPECT_TRUE(d.cleared_centres.empty());
    EXPECT_DOUBLE_EQ(d.new_area_mm2, n.coverable_area_mm2);
}

TEST(DecomposedArea, IsExactlyEmptyWhenBothToolsReachTheSame) {
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    for (const auto& [m, n] : {std::pair{12.0, 10.0}, {12.0, 3.0}, {11.0, 10.9}, {10.0, 10.0}}) {
        const DecomposedArea d =
            decomposedArea(ground, std::make_unique<CutterArea>(access(ground, m)).get(), access(ground, n));
        EXPECT_TRUE(d.centres.empty()) << m << " " << n;
        EXPECT_TRUE(d.area.empty()) << m << " " << n;
        EXPECT_DOUBLE_EQ(d.new_area_mm2, 0) << m << " " << n;
    }
}

TEST(DecomposedArea, OfAPocketIsItsFourCorners) {
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    const CutterArea m = access(ground, 16);
    const CutterArea n = access(ground, 8);
    const DecomposedArea d = decomposedArea(ground, &m, n);
    EXPECT_EQ(components(d.centres).size(), 4U);
    EXPECT_NEAR(d.new_area_mm2, (4 - kPi) * (64 - 36), 2e-2);
    EXPECT_NEAR(d.new_area_mm2, n.coverable_area_mm2 - m.coverable_area_mm2, 2e-2);
    EXPECT_LT(missed(m, n, d), 1e-3);
    EXPECT_NEAR(area(d.centres) + area(d.cleared_centres), area(n.free_centres), 2e-2);
}

TEST(DecomposedArea, ServesTheNecksAWiderCutterCannotPass) {
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    const CutterArea m = access(ground, 20);
    const CutterArea n = access(ground, 12);
    const DecomposedArea d = decomposedArea(ground, &m, n);
    EXPECT_NEAR(d.new_area_mm2, n.coverable_area_mm2 - m.coverable_area_mm2, 2e-2);
    EXPECT_LT(missed(m, n, d), 1e-3);
}

TEST(DecomposedArea, BesideAnOpenEdgeKeepsNoCentresThatClearNothing) {
    const Region shoulder = makeRectangle({0, 0}, {50, 4});
    const FeatureGround ground(makeFeature(shoulder, makeRectangle({0, 4}, {50, 30}), 58), kTol);
    const CutterArea m = access(ground, 20);
    const CutterArea n = access(ground, 6);
    const DecomposedArea d = decomposedArea(ground, &m, n);
    EXPECT_TRUE(d.centres.empty());
    EXPECT_DOUBLE_EQ(d.new_area_mm2, 0);
}

TEST(DecomposedArea, OfASlotWiderThanOnlyTheSecondToolIsTheSlot) {
    const Region slot = makeRectangle({-5, 0}, {5, 40});
    const Region block = subtract(makeRectangle({-40, 0}, {40, 60}), slot, kTol);
    const FeatureGround ground(makeFeature(slot, block, 10), kTol);
    const CutterArea m = access(ground, 16);
    const CutterArea n = access(ground, 8);
    const DecomposedArea d = decomposedArea(ground, &m, n);
    EXPECT_EQ(components(d.centres).size(), 1U);
    EXPECT_NEAR(d.new_area_mm2, n.coverable_area_mm2 - m.coverable_area_mm2, 2e-2);
    EXPECT_LT(missed(m, n, d), 1e-3);
}

TEST(DecomposedArea, CountsNoGroundAsClearedThatNoPassReaches) {
    // Beside the island's corner the way narrows to the first tool's own width, 2 mm, at x = 20. Its strip of
    // centres is half a sliver wide 0.09 mm before that: no pass goes on from there.
    Tolerances no_fit = kTol;
    no_fit.fit_mm = 0;  // else the way is a slot, and the tool goes along its middle
    const Region island = makeRoundedRectangle({16, 10}, {50, 28}, 4);
    const Region pocket = subtract(makeRectangle({0, 0}, {66, 30}), island, kTol);
    const CutterArea m = access(FeatureGround(closedPocket(pocket), no_fit), 2);
    ASSERT_TRUE(contains(m.free_centres, {20 - 0.03, 29 - 4e-5})) << "reached on paper";
    for (const double open_mm : {0.0, 10.0}) {
        Feature feature = closedPocket(pocket);
        feature.open_length_mm = open_mm;
        const FeatureGround ground(feature, no_fit);
        const CutterArea first = access(ground, 2);
        const DecomposedArea d = decomposedArea(ground, &first, access(ground, 1.5));
        const Vec2 beside_the_island(20, 28.7501);
        EXPECT_TRUE(contains(d.centres, beside_the_island));
        EXPECT_FALSE(contains(d.cleared_centres, beside_the_island));
        EXPECT_TRUE(contains(d.cleared_centres, {19, 29}));
    }
}

TEST(DecomposedArea, RefusesTheSmallerToolFirst) {
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    const CutterArea m = access(ground, 6);
    EXPECT_THROW(decomposedArea(ground, &m, access(ground, 8)), Error);
}

}  // namespace
}  // namespace stepmill
