// Cutters as wide as the slot.

#include <gtest/gtest.h>

#include "stepmill/access/slivers.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"
#include "stepmill/toolpath/swept_region.h"
#include "support/clearing_tasks.h"
#include "support/grounds.h"
#include "support/sound_path.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::closedPocket;
using test::endMill;
using test::kMachine;
using test::kMaterial;
using test::kTol;
using test::makeFeature;

/// A slot from the left face of a block into it.
Feature openSlot(double width_mm, double depth_mm = 3) {
    const Region slot = makeRectangle({0, -width_mm / 2}, {24, width_mm / 2});
    const Region block = makeRectangle({0, -20}, {44, 20});
    return makeFeature(slot, subtract(block, slot, kTol), width_mm, depth_mm);
}

CutterArea reached(const FeatureGround& ground, double diameter_mm) {
    return toolReach(ground, endMill(diameter_mm), kMaterial).cutter;
}

double levelMm(const Toolpath& path) {
    double sum_mm = 0;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const bool level = move.kind == MoveKind::Feed || move.kind == MoveKind::Slot;
        if (level) sum_mm += length(Vec2(from.head<2>()), {Vec2(move.to.head<2>()), move.arc});
        from = move.to;
    }
    return sum_mm;
}

Toolpath pathIn(const Feature& feature, const FeatureGround& ground, const CutterArea& area) {
    ClearingTask task = test::taskOf(feature, area, decomposedArea(ground, nullptr, area), kMachine);
    const Toolpath path = clearArea(task, endMill(2 * area.radius_mm),
                                    test::cuttingData(0.4 * area.radius_mm, 3), kMachine, kTol);
    EXPECT_GE(prove(path, task, area.radius_mm, kTol).least_clearance_mm, -kTol.gouge_mm);
    EXPECT_TRUE(prove(path, task, area.radius_mm, kTol).rapids_clear);
    return path;
}

TEST(SlotMiddles, AnOpenSlotOfTheCuttersWidthIsReachedDownToItsCorners) {
    const Feature feature = openSlot(2);
    const FeatureGround ground(feature, kTol);
    const CutterArea area = reached(ground, 2);
    ASSERT_EQ(area.slot_middles.size(), 1U);
    ASSERT_FALSE(area.entries.empty());
    EXPECT_EQ(area.entries.front().kind, EntryKind::OpenEdge);
    EXPECT_NEAR(area.coverable_area_mm2, 48 - (2 - kPi / 2), 0.02);
}

TEST(SlotMiddles, OnePassAlongTheMiddleClearsIt) {
    const Feature feature = openSlot(2);
    const FeatureGround ground(feature, kTol);
    const CutterArea area = reached(ground, 2);
    const Toolpath path = pathIn(feature, ground, area);
    // From a radius outside to a radius off the end, once.
    EXPECT_NEAR(levelMm(path), 24, 1.2);
    for (const Move& move : path.moves)
        EXPECT_LE(std::abs(move.to.y()), kTol.fit_mm + 2e-6);
}

TEST(SlotMiddles, AClosedSlotIsEnteredByARampAlongIt) {
    const Region slot = makeRoundedRectangle({0, 0}, {30, 6}, 3);
    const Feature feature = closedPocket(slot, 2);
    const FeatureGround ground(feature, kTol);
    const CutterArea area = reached(ground, 6);
    ASSERT_EQ(area.slot_middles.size(), 1U);
    EXPECT_EQ(area.entries.front().kind, EntryKind::Ramp);
    EXPECT_NEAR(area.coverable_area_mm2, stepmill::area(slot), 0.02);
    EXPECT_FALSE(pathIn(feature, ground, area).moves.empty());
}

TEST(SlotMiddles, ASlotOffAPocketIsCutBesideIt) {
    const Region pocket = unite(makeRectangle({0, 0}, {20, 20}), makeRectangle({19, 8}, {40, 12}), kTol);
    const Feature feature = closedPocket(pocket, 2);
    const FeatureGround ground(feature, kTol);
    const CutterArea area = reached(ground, 4);
    EXPECT_EQ(area.slot_middles.size(), 1U);
    EXPECT_EQ(components(area.free_centres).size(), 2U);
    EXPECT_NEAR(area.coverable_area_mm2, 480 - 6 * (4 - kPi), 0.05);
    EXPECT_FALSE(pathIn(feature, ground, area).moves.empty());
}

TEST(SlotMiddles, ASlotAMicrometreWiderThatLeadsIntoAirIsCutDownItsMiddle) {
    for (const double wider_mm : {0.0005, 0.001, 0.0015}) {
        SCOPED_TRACE(wider_mm);
        const double width_mm = 8 + wider_mm;
        const Region slot = makeRectangle({0, -width_mm / 2}, {60, width_mm / 2});
        const Region block = makeRectangle({0, -30}, {60, 30});
        const Feature feature = makeFeature(slot, subtract(block, slot, kTol), width_mm, 3);
        const FeatureGround ground(feature, kTol);
        const CutterArea area = reached(ground, 8);
        EXPECT_EQ(area.slot_middles.size(), 1U);
        EXPECT_NEAR(area.coverable_area_mm2, 60 * width_mm, 0.02);
        // What counts as swept, too.
        EXPECT_LT(stepmill::area(subtract(slot, area.swept.region(), kTol)), 0.05);
        EXPECT_FALSE(pathIn(feature, ground, area).moves.empty());
    }
}

TEST(SlotMiddles, ARingSlotIsGoneRoundOnce) {
    const Region ring = subtract(makeCircle({0, 0}, 12), makeCircle({0, 0}, 8), kTol);
    const Feature feature = closedPocket(ring, 2);
    const FeatureGround ground(feature, kTol);
    EXPECT_TRUE(reached(ground, 4).free_centres.empty()) << "no straight stretch to ramp down";
    ToolAssembly plunging = endMill(4);
    plunging.centre_cutting = true;
    plunging.max_plunge_mm = 2;
    const CutterArea area = toolReach(ground, plunging, kMaterial).cutter;
    ASSERT_EQ(area.slot_middles.size(), 1U);
    EXPECT_NEAR(length(area.slot_middles.front()), 20 * kPi, 0.1);
}

TEST(SlotMiddles, OneMicrometreNarrowerIsTooNarrow) {
    EXPECT_TRUE(reached(FeatureGround(openSlot(1.999), kTol), 2).slot_middles.empty());
    EXPECT_FALSE(reached(FeatureGround(openSlot(1.9992), kTol), 2).slot_middles.empty());
}

TEST(SlotMiddles, AWiderSlotIsCutAsEver) {
    const CutterArea area = reached(FeatureGround(openSlot(2.1), kTol), 2);
    EXPECT_TRUE(area.slot_middles.empty());
    EXPECT_NEAR(area.coverable_area_mm2, 24 * 2.1, 1);
}

TEST(SlotMiddles, ACornerOrAHoleIsNoSlot) {
    EXPECT_TRUE(reached(FeatureGround(closedPocket(makeCircle({0, 0}, 3)), kTol), 6).slot_middles.empty());
    EXPECT_TRUE(reached(FeatureGround(closedPocket(makePolygon({{0, 0}, {40, 0}, {20, 10}})), kTol), 4)
                    .slot_middles.empty());
}

TEST(SlotMiddles, WithoutAFitToleranceNoneIsEntered) {
    Tolerances tol = kTol;
    tol.fit_mm = 0;
    EXPECT_TRUE(reached(FeatureGround(openSlot(2), tol), 2).slot_middles.empty());
}

TEST(SlotMiddles, ASmallerCutterHasOnlyTheCornersLeft) {
    const FeatureGround ground(openSlot(2), kTol);
    const CutterArea m = reached(ground, 2);
    const CutterArea n = reached(ground, 1);
    const DecomposedArea rest = decomposedArea(ground, &m, n);
    EXPECT_NEAR(rest.new_area_mm2, (2 - kPi / 2) * 0.75, 0.02);
    EXPECT_EQ(components(rest.centres).size(), 2U);
}

/// Level ways of the path.
std::vector<Path> levelWays(const Toolpath& path) {
    std::vector<Path> ways;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        if (move.kind == MoveKind::Feed || move.kind == MoveKind::Slot)
            ways.push_back({Vec2(from.head<2>()), {{Vec2(move.to.head<2>()), move.arc}}});
        from = move.to;
    }
    return ways;
}

/// A notch of the cutter's own radius: centres run into a cusp between its corners, and the ring beside the
/// walls ends 50 um before it.
TEST(Cusps, ANotchOfTheCuttersRadiusIsCutToItsEnd) {
    const Region notched = unite(makeRectangle({0, 0}, {60, 40}), makeCircle({30, 40}, 5), kTol);
    const Feature feature = closedPocket(notched, 3);
    const FeatureGround ground(feature, kTol);
    const CutterArea area = reached(ground, 10);
    const Toolpath path = pathIn(feature, ground, area);
    const Region left = toolpath::notSwept(area.coverable, levelWays(path), 5, kTol);
    EXPECT_TRUE(offset(left, -2 * kTol.sliver_mm, kTol).empty()) << stepmill::area(left);
}

}  // namespace
}  // namespace stepmill
