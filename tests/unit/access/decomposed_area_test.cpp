#include <gtest/gtest.h>

#include "access/slivers.h"
#include "grounds.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill {
namespace {

using test::closedPocket;
using test::endMill;
using test::kMaterial;
using test::makeFeature;

const Tolerances kTol;

AccessibleArea access(const FeatureGround& ground, double diameter_mm) {
    return accessibleArea(ground, endMill(diameter_mm), kMaterial);
}

Region islandPocket() {
    return subtract(makeRoundedRectangle({0, 0}, {70, 50}, 6), makeCircle({35, 25}, 8), kTol);
}

/// A_n n T without A_m u D_mn: what eq. 2 of [DSouza2006] says is nothing.
double missed(const AccessibleArea& m, const AccessibleArea& n, const DecomposedArea& d) {
    const Region both = unite(m.accessible, d.area, kTol);
    return area(access::withoutSliverComponents(subtract(n.coverable, both, kTol), kTol));
}

TEST(DecomposedArea, OfAFirstToolIsItsAccessibleArea) {
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    const AccessibleArea n = access(ground, 10);
    const DecomposedArea d = decomposedArea(ground, nullptr, n);
    EXPECT_DOUBLE_EQ(area(d.area), area(n.accessible));
    EXPECT_DOUBLE_EQ(area(d.centres), area(n.free_centres));
    EXPECT_TRUE(d.cleared_centres.empty());
    EXPECT_DOUBLE_EQ(d.new_area_mm2, n.coverable_area_mm2);
}

TEST(DecomposedArea, IsExactlyEmptyWhenBothToolsReachTheSame) {
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    for (const auto& [m, n] : {std::pair{12.0, 10.0}, {12.0, 3.0}, {11.0, 10.9}, {10.0, 10.0}}) {
        const DecomposedArea d = decomposedArea(
            ground, std::make_unique<AccessibleArea>(access(ground, m)).get(), access(ground, n));
        EXPECT_TRUE(d.centres.empty()) << m << " " << n;
        EXPECT_TRUE(d.area.empty()) << m << " " << n;
        EXPECT_DOUBLE_EQ(d.new_area_mm2, 0) << m << " " << n;
    }
}

TEST(DecomposedArea, OfAPocketIsItsFourCorners) {
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    const AccessibleArea m = access(ground, 16);
    const AccessibleArea n = access(ground, 8);
    const DecomposedArea d = decomposedArea(ground, &m, n);
    EXPECT_EQ(components(d.centres).size(), 4U);
    EXPECT_NEAR(d.new_area_mm2, (4 - kPi) * (64 - 36), 2e-2);
    EXPECT_NEAR(d.new_area_mm2, n.coverable_area_mm2 - m.coverable_area_mm2, 2e-2);
    EXPECT_LT(missed(m, n, d), 1e-3);
    EXPECT_NEAR(area(d.centres) + area(d.cleared_centres), area(n.free_centres), 2e-2);
}

TEST(DecomposedArea, ServesTheNecksAWiderCutterCannotPass) {
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    const AccessibleArea m = access(ground, 20);
    const AccessibleArea n = access(ground, 12);
    const DecomposedArea d = decomposedArea(ground, &m, n);
    EXPECT_NEAR(d.new_area_mm2, n.coverable_area_mm2 - m.coverable_area_mm2, 2e-2);
    EXPECT_LT(missed(m, n, d), 1e-3);
}

TEST(DecomposedArea, BesideAnOpenEdgeKeepsNoCentresThatClearNothing) {
    const Region shoulder = makeRectangle({0, 0}, {50, 4});
    const FeatureGround ground(makeFeature(shoulder, makeRectangle({0, 4}, {50, 30}), 58), kTol);
    const AccessibleArea m = access(ground, 20);
    const AccessibleArea n = access(ground, 6);
    const DecomposedArea d = decomposedArea(ground, &m, n);
    EXPECT_TRUE(d.centres.empty());
    EXPECT_DOUBLE_EQ(d.new_area_mm2, 0);
}

TEST(DecomposedArea, OfASlotWiderThanOnlyTheSecondToolIsTheSlot) {
    const Region slot = makeRectangle({-5, 0}, {5, 40});
    const Region block = subtract(makeRectangle({-40, 0}, {40, 60}), slot, kTol);
    const FeatureGround ground(makeFeature(slot, block, 10), kTol);
    const AccessibleArea m = access(ground, 16);
    const AccessibleArea n = access(ground, 8);
    const DecomposedArea d = decomposedArea(ground, &m, n);
    EXPECT_EQ(components(d.centres).size(), 1U);
    EXPECT_NEAR(d.new_area_mm2, n.coverable_area_mm2 - m.coverable_area_mm2, 2e-2);
    EXPECT_LT(missed(m, n, d), 1e-3);
}

TEST(DecomposedArea, RefusesTheSmallerToolFirst) {
    const FeatureGround ground(closedPocket(islandPocket()), kTol);
    const AccessibleArea m = access(ground, 6);
    EXPECT_THROW(decomposedArea(ground, &m, access(ground, 8)), Error);
}

}  // namespace
}  // namespace stepmill
