// The pass along the walls after roughing with an allowance.

#include "stepmill/toolpath/finish_walls.h"

#include <gtest/gtest.h>

#include "stepmill/core/units.h"
#include "support/clearing_tasks.h"
#include "support/tolerances.h"

namespace stepmill::toolpath {
namespace {

using namespace test;

using test::kMachine;
using test::kTol;
constexpr double kRadiusMm = 4;
constexpr double kAllowanceMm = 0.3;

/// A target whose walls still have the allowance, as roughing by the same cutter left it.
struct Roughed {
    ClearingTask clearing;
    Region strip;

    explicit Roughed(const Region& target, const Region& open = {}) {
        clearing = fullTask(target, blockAround(target, open, kTol), kRadiusMm, kTol);
        const Region stays = offset(clearing.obstruction, kAllowanceMm, kTol);
        const Region roughed = subtract(target, stays, kTol);
        clearing.cleared_centres = fullTask(roughed, stays, kRadiusMm, kTol).free_centres;
        const Region swept = offset(clearing.free_centres, kRadiusMm, kTol);
        const Region before = offset(clearing.cleared_centres, kRadiusMm, kTol);
        strip = subtract(intersect(swept, target, kTol), before, kTol);
    }

    Toolpath path() const {
        return finishWalls({clearing, strip, kAllowanceMm}, flatEndMill(2 * kRadiusMm), cuttingData(4, 4),
                           kMachine, kTol);
    }
};

Vec2 directionInto(const Vec3& from, const Move& move) {
    return tangentAt(from.head<2>(), Segment{move.to.head<2>(), move.arc}, 1);
}

Vec2 directionOutOf(const Vec3& from, const Move& move) {
    return tangentAt(from.head<2>(), Segment{move.to.head<2>(), move.arc}, 0);
}

/// Indices of moves that feed on the level.
std::vector<std::size_t> levelFeeds(const Toolpath& path) {
    std::vector<std::size_t> feeds;
    for (std::size_t i = 1; i < path.moves.size(); ++i)
        if (path.moves[i].kind == MoveKind::Feed && path.moves[i].to.z() == path.moves[i - 1].to.z())
            feeds.push_back(i);
    return feeds;
}

void expectFinished(const Toolpath& path, const Roughed& roughed) {
    const PathProof proof = prove(path, roughed.clearing, kRadiusMm, kTol);
    EXPECT_GE(proof.least_clearance_mm, 0);
    EXPECT_TRUE(proof.rapids_clear);
    const Region left = leftBy(path, roughed.strip, roughed.clearing.floor_z_mm, kRadiusMm, kTol);
    EXPECT_LT(area(left), 0.01);
}

TEST(FinishWalls, OfAPocketGoesRoundOnceOnTangentQuarterCircles) {
    const Roughed roughed(makeRoundedRectangle({0, 0}, {60, 40}, 6));
    const Toolpath path = roughed.path();
    expectFinished(path, roughed);
    EXPECT_EQ(path.depths, 1);
    EXPECT_EQ(path.pattern, "walls");
    const std::vector<std::size_t> feeds = levelFeeds(path);
    ASSERT_GE(feeds.size(), 4U);
    const Move& in = path.moves[feeds.front()];
    const Move& out = path.moves[feeds.back()];
    ASSERT_TRUE(in.arc && out.arc);
    EXPECT_NEAR(in.arc->radius_mm, kRadiusMm / 2, 1e-9);
    // From each move to the next the direction goes on: no corner but where the walls have one.
    for (std::size_t k = 1; k < feeds.size(); ++k) {
        const Vec3& before = path.moves[feeds[k - 1] - 1].to;
        const Vec3& at = path.moves[feeds[k] - 1].to;
        const Vec2 arrives = directionInto(before, path.moves[feeds[k - 1]]);
        EXPECT_GT(arrives.dot(directionOutOf(at, path.moves[feeds[k]])), 1 - 1e-6) << k;
    }
    const double contour_mm = perimeter(roughed.clearing.free_centres);
    const double leads_mm = 2 * kRadiusMm / 2 * kPi / 2;
    EXPECT_NEAR(path.totals.cut_length_mm, contour_mm + kOverlapMm + leads_mm + 1, 0.1);
}

TEST(FinishWalls, IsClimbMilling) {
    const Roughed roughed(makeRoundedRectangle({0, 0}, {60, 40}, 6));
    // Counter-clockwise in a pocket: the wall on the right of a spindle that turns clockwise.
    for (const Move& move : roughed.path().moves)
        EXPECT_TRUE(!move.arc || move.arc->ccw);
}

TEST(FinishWalls, GoesRoundIslandsToo) {
    const Roughed roughed(subtract(makeRoundedRectangle({0, 0}, {60, 40}, 6), makeCircle({30, 20}, 5), kTol));
    const Toolpath path = roughed.path();
    expectFinished(path, roughed);
    int clockwise = 0;
    for (const Move& move : path.moves)
        if (move.arc && !move.arc->ccw) ++clockwise;
    EXPECT_GE(clockwise, 2);
}

TEST(FinishWalls, RunsOutOverOpenEdgesAndLeavesThemAlone) {
    // A slot of 20 mm, open on the right.
    const Region slot = makeRectangle({0, 0}, {40, 20});
    const Roughed roughed(slot, makeRectangle({39, 0}, {60, 20}));
    const Toolpath path = roughed.path();
    expectFinished(path, roughed);
    const std::vector<std::size_t> feeds = levelFeeds(path);
    ASSERT_FALSE(feeds.empty());
    const Vec3 begin = path.moves[feeds.front() - 1].to;
    const Vec3 end = path.moves[feeds.back()].to;
    EXPECT_GT(begin.x(), 40 + kRadiusMm) << "begins beside the material";
    EXPECT_GT(end.x(), 40 + kRadiusMm);
    // Bottom wall, end wall, top wall; nothing along the open edge.
    EXPECT_LT(path.totals.cut_length_mm, 2 * (40 + 2 * kRadiusMm) + 20);
}

TEST(FinishWalls, NarrowsItsLeadsWhereThereIsLittleRoom) {
    // 3.2 mm for centres: a quarter circle of 2 mm does not fit, 1 mm does.
    const Roughed roughed(makeRoundedRectangle({0, 0}, {60, 2 * kRadiusMm + 1.6}, kRadiusMm + 0.5));
    const Toolpath path = roughed.path();
    expectFinished(path, roughed);
    const Move& in = path.moves[levelFeeds(path).front()];
    ASSERT_TRUE(in.arc);
    EXPECT_LT(in.arc->radius_mm, kRadiusMm / 2 - 0.1);
    EXPECT_GE(in.arc->radius_mm, kAllowanceMm);
}

TEST(FinishWalls, GoesStraightDownWhereNoGroundIsClearedBesideTheWall) {
    Roughed roughed(makeRoundedRectangle({0, 0}, {60, 40}, 6));
    roughed.clearing.cleared_centres = {};
    const Toolpath path = roughed.path();
    const bool plunges = std::any_of(path.moves.begin(), path.moves.end(), [](const Move& move) {
        return move.kind == MoveKind::Plunge && !move.in_air;
    });
    EXPECT_TRUE(plunges);
    EXPECT_GE(prove(path, roughed.clearing, kRadiusMm, kTol).least_clearance_mm, 0);
}

TEST(FinishWalls, HasNoMovesWhereNothingIsLeft) {
    Roughed roughed(makeRoundedRectangle({0, 0}, {60, 40}, 6));
    roughed.strip = {};
    EXPECT_TRUE(roughed.path().moves.empty());
}

TEST(FinishingLayers, KeepToFlutesDiametersAndTheChipOfRoughing) {
    ToolAssembly tool = flatEndMill(10);
    tool.flute_length_mm = 50;
    EXPECT_EQ(finishingDepths(20, 0.3, tool, cuttingData(5, 4)), 1);
    EXPECT_EQ(finishingDepths(21, 0.3, tool, cuttingData(5, 4)), 2) << "two diameters";
    EXPECT_EQ(finishingDepths(20, 2, tool, cuttingData(5, 4)), 2) << "2 x 10 is as much as 5 x 4";
    tool.flute_length_mm = 12;
    EXPECT_EQ(finishingDepths(20, 0.3, tool, cuttingData(5, 4)), 2) << "the flutes";
}

TEST(FinishWalls, TakesDeepWallsInEvenDepths) {
    Roughed roughed(makeRoundedRectangle({0, 0}, {60, 40}, 6));
    roughed.clearing.floor_z_mm = -30;
    const Toolpath path = roughed.path();
    expectFinished(path, roughed);
    EXPECT_EQ(path.depths, 2);
    EXPECT_EQ(path.step_down_mm, 15);
}

}  // namespace
}  // namespace stepmill::toolpath
