// Clearing at constant engagement.

#include <gtest/gtest.h>

#include "stepmill/core/units.h"
#include "stepmill/toolpath/adaptive_cutting.h"
#include "stepmill/toolpath/cut_ground.h"
#include "support/clearing_tasks.h"
#include "support/raster_engagement.h"
#include "support/sound_path.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using namespace test;

const Machine kQuickMachine = machineWithRapid(5000);
/// As proofs have them: the angle may be more by this share, swept ground counts as narrower by that.
constexpr double kOverAngle = 0.02;
constexpr double kCusp = 0.005;

CuttingData deepAndNarrow(double step_over_mm, double step_down_mm) {
    CuttingData cutting = cuttingData(step_over_mm, step_down_mm);
    cutting.ramp_angle_deg = 5;
    cutting.adaptive = AdaptiveData{step_over_mm, step_down_mm, 0, 0, 0};
    return cutting;
}

Toolpath adaptiveOf(ClearingTask task, double diameter_mm, double step_over_mm, double step_down_mm) {
    task.pattern = Pattern::Adaptive;
    return clearArea(task, flatEndMill(diameter_mm), deepAndNarrow(step_over_mm, step_down_mm), kQuickMachine,
                     kTol);
}

/// The greatest engagement of the path's cuts at the floor, ways in aside [rad].
double greatestEngagement(const Toolpath& path, const ClearingTask& task, double radius_mm) {
    const CutGround ground(task.target, task.top_z_mm);
    CutFollower follower(ground, radius_mm, path.step_down_mm, kCusp, CutMeasures::WidthsAndAngles);
    double greatest = 0;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const MoveCut cut = follower.next(from, move);
        from = move.to;
        if (cut.depth_mm >= path.step_down_mm - 1e-6) greatest = std::max(greatest, cut.engaged_rad);
    }
    return greatest;
}

/// Every glide is level or straight up and stays in ground that raster cells show as cleared.
void expectGlidesClear(const Toolpath& path, const ClearingTask& task, double radius_mm) {
    Toolpath as_rapids = path;
    for (Move& move : as_rapids.moves)
        if (isGlide(move)) move.kind = MoveKind::Rapid;
    EXPECT_EQ(simulate(as_rapids, task, radius_mm, 0.1, 0.15).bad_rapids, 0);
    EXPECT_TRUE(prove(as_rapids, task, radius_mm, kTol).rapids_clear);
}

ClearingTask commonPocket(double radius_mm) {
    Region pocket = makeRoundedRectangle({0, 0}, {70, 50}, 6);
    pocket.loops.push_back(reversed(makeCircle({35, 25}, 8).loops.front()));
    ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), radius_mm, kTol);
    task.floor_z_mm = -12;
    return task;
}

struct DeepCut {
    double diameter_mm;
    double step_over_share;
    double volume_s;  ///< the volume alone at step-over, depth and feed
};

class AdaptiveCommonPocket : public testing::TestWithParam<DeepCut> {};

TEST_P(AdaptiveCommonPocket, EngagesNoMoreThanAStraightCut) {
    const auto [d, share, volume_s] = GetParam();
    const ClearingTask task = commonPocket(d / 2);
    const Toolpath path = adaptiveOf(task, d, share * d, 12);
    ASSERT_EQ(path.pattern, "adaptive");
    EXPECT_EQ(path.depths, 1);
    EXPECT_NEAR(path.engagement_rad, std::acos(1 - 2 * share), 1e-9);
    EXPECT_LE(greatestEngagement(path, task, d / 2), path.engagement_rad * (1 + kOverAngle));
    RecordProperty("time_s", std::to_string(path.totals.time_s()));
    RecordProperty("over_volume", std::to_string(path.totals.time_s() / volume_s));
    expectSound(path, task, d / 2);
    expectGlidesClear(path, task, d / 2);
}

INSTANTIATE_TEST_SUITE_P(Cutters, AdaptiveCommonPocket,
                         testing::Values(DeepCut{12, 0.17, 96.1}, DeepCut{12, 0.25, 65.4},
                                         DeepCut{6, 0.17, 192.2}));

TEST(Adaptive, KeepsArcs) {
    const Toolpath path = adaptiveOf(commonPocket(6), 12, 2, 12);
    const auto arcs =
        std::count_if(path.moves.begin(), path.moves.end(), [](const Move& move) { return move.arc; });
    EXPECT_GT(2 * static_cast<std::size_t>(arcs), path.moves.size() / 2);
}

TEST(Adaptive, IsTheSameEveryTime) {
    const Toolpath once = adaptiveOf(commonPocket(6), 12, 2, 12);
    const Toolpath again = adaptiveOf(commonPocket(6), 12, 2, 12);
    ASSERT_EQ(once.moves.size(), again.moves.size());
    for (std::size_t i = 0; i < once.moves.size(); ++i)
        EXPECT_EQ(once.moves[i].to, again.moves[i].to);
}

/// An independent meter agrees to within what its cells leave unsure.
TEST(Adaptive, EngagesNoMoreByARaster) {
    constexpr double kCellMm = 0.025;
    const double r = 4;
    Region pocket = makeRoundedRectangle({0, 0}, {38, 30}, 5);
    pocket.loops.push_back(reversed(makeCircle({22, 15}, 3).loops.front()));
    const ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), r, kTol);
    const Toolpath path = adaptiveOf(task, 2 * r, 0.17 * 2 * r, -task.floor_z_mm);
    ASSERT_EQ(path.pattern, "adaptive");
    EngagementMeter meter(task, r, kCellMm, kGrazeShare * r);
    double greatest = 0;
    bool entered = false;  // the way in is full width
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const bool level = from.z() == task.floor_z_mm && move.to.z() == task.floor_z_mm;
        entered = entered || isGlide(move);
        if (!level || isGlide(move)) meter.beginPass();
        if (level && move.kind != MoveKind::Rapid) {
            const Edge edge = edgeOf(from, move);
            greatest = std::max(greatest, meter.follow(edge, entered));
        }
        from = move.to;
    }
    // What is looked at lies outside the rim, which meets the ground's edge at the planned angle.
    const double unsure_rad =
        (meter.skinMm() + kCellMm) / (r * std::sin(path.engagement_rad)) + EngagementMeter::kRayRad;
    EXPECT_LE(greatest, path.engagement_rad * (1 + kOverAngle) + unsure_rad);
    EXPECT_GT(greatest, path.engagement_rad / 2);
}

TEST(Adaptive, ComesInOverAnOpenSide) {
    const Region step = makeRectangle({0, 0}, {60, 30});
    const Region open = makeRectangle({-20, -20}, {80, 0});
    const ClearingTask task = fullTask(step, blockAround(step, open, kTol), 5, kTol);
    const Toolpath path = adaptiveOf(task, 10, 1.5, 6);
    ASSERT_EQ(path.pattern, "adaptive");
    for (const Move& move : path.moves)
        EXPECT_NE(move.kind, MoveKind::Ramp);
    EXPECT_LE(greatestEngagement(path, task, 5), path.engagement_rad * (1 + kOverAngle));
    expectSound(path, task, 5);
}

TEST(Adaptive, IsNotOfferedInASlotOfItsOwnWidth) {
    const Region slot = makeRectangle({0, 0}, {60, 10.001});
    ClearingTask task = fullTask(slot, blockAround(slot, {}, kTol), 5, kTol);
    EXPECT_NE(adaptiveOf(task, 10, 1.5, 6).pattern, "adaptive");
}

TEST(Adaptive, NeverMakesTheBestPathSlower) {
    ClearingTask task = commonPocket(6);
    task.patterns = {Pattern::ContourInsideOut, Pattern::ContourOutsideIn, Pattern::StockOffset,
                     Pattern::Zigzag, Pattern::OneWay};
    for (const double step_down_mm : {2.0, 12.0}) {
        CuttingData cutting = cuttingData(5, step_down_mm);
        cutting.adaptive = AdaptiveData{2, 12, 1500, 0, 0};
        const Toolpath without = clearArea(task, flatEndMill(12), cutting, kQuickMachine, kTol);
        ClearingTask any = task;
        any.patterns.clear();
        const Toolpath with = clearArea(any, flatEndMill(12), cutting, kQuickMachine, kTol);
        EXPECT_LE(with.totals.motion_time_s, without.totals.motion_time_s);
        EXPECT_EQ(with.pattern == "adaptive", step_down_mm < 3);
    }
}

TEST(AdaptiveCutting, RemovesNoMoreThanTheUsualCut) {
    ToolAssembly tool = flatEndMill(12);
    tool.flute_length_mm = 30;
    const CuttingData usual = cuttingData(5, 6);
    const auto deep = adaptiveCutting(tool, usual, 24);
    ASSERT_TRUE(deep);
    EXPECT_EQ(deep->step_down_mm, 24);
    // A quarter of the depth, half as fast again: 5 x 6 / (24 x 1.5).
    EXPECT_NEAR(deep->step_over_mm, 5.0 * 6 / 24 / 1.5, 1e-6);
    EXPECT_NEAR(deep->feed_mm_per_min, 1.5 * usual.feed_mm_per_min, 1e-6);
    EXPECT_LE(ratedRemovalMm3PerMin(*deep), ratedRemovalMm3PerMin(usual) * (1 + 1e-9));
}

TEST(AdaptiveCutting, GoesNoDeeperThanTheFlutes) {
    ToolAssembly tool = flatEndMill(12);
    tool.flute_length_mm = 20;
    const auto deep = adaptiveCutting(tool, cuttingData(5, 6), 36);
    ASSERT_TRUE(deep);
    EXPECT_EQ(deep->step_down_mm, 18);
}

TEST(AdaptiveCutting, IsTheLibrarysWhereThatHasASet) {
    CuttingData cutting = cuttingData(5, 6);
    cutting.adaptive = AdaptiveData{1.2, 10, 1800, 9000, 0.3};
    const auto deep = adaptiveCutting(flatEndMill(12), cutting, 15);
    ASSERT_TRUE(deep);
    EXPECT_EQ(deep->step_over_mm, 1.2);
    EXPECT_EQ(deep->step_down_mm, 7.5);
    EXPECT_EQ(deep->feed_mm_per_min, 1800);
    EXPECT_EQ(deep->speed_rpm, 9000);
}

TEST(AdaptiveCutting, IsNotMadeWhereItWouldOnlyRub) {
    ToolAssembly tool = flatEndMill(12);
    tool.flute_length_mm = 60;
    EXPECT_FALSE(adaptiveCutting(tool, cuttingData(1, 1), 60));
}

}  // namespace
}  // namespace stepmill
