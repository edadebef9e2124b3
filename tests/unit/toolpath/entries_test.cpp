// Which way a cutter goes down, and how it leaves.

#include <gtest/gtest.h>

#include "stepmill/core/units.h"
#include "support/clearing_tasks.h"
#include "support/sound_path.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using namespace test;

using test::kMachine;
using test::kTol;

/// A blind hole of 6 mm, 20 deep, as a 4 mm cutter with a long reach clears it.
ClearingTask deepHole() {
    const Region hole = makeCircle({0, 0}, 3);
    ClearingTask task = fullTask(hole, blockAround(hole, {}, kTol), 2, kTol);
    task.floor_z_mm = -20;
    return task;
}

Toolpath inHole(double max_plunge_mm, double plunge_feed = 155) {
    ToolAssembly tool = flatEndMill(4);
    tool.max_plunge_mm = max_plunge_mm;
    CuttingData cutting = cuttingData(1.2, 1.6);
    cutting.feed_mm_per_min = 520;
    cutting.plunge_feed_mm_per_min = plunge_feed;
    cutting.ramp_angle_deg = 2;
    return clearArea(deepHole(), tool, cutting, kMachine, kTol);
}

double deepestPlunge(const Toolpath& path) {
    double deepest = 0;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        if (move.kind == MoveKind::Plunge && !move.in_air)
            deepest = std::max(deepest, from.z() - move.to.z());
        from = move.to;
    }
    return deepest;
}

TEST(WayDown, IsStraightInAHoleWhereTheToolMayPlunge) {
    const Toolpath plunged = inHole(2);
    EXPECT_LE(deepestPlunge(plunged), 1.6 + 0.2 + 1e-9);
    EXPECT_LT(plunged.totals.time_s(), 22);
    expectSound(plunged, deepHole(), 2);
}

TEST(WayDown, TakesMoreDepthsWherePlungesOfLessThanOneAreQuickerThanRamps) {
    const Toolpath plunged = inHole(0.5);
    EXPECT_EQ(plunged.depths, 40);
    EXPECT_LE(deepestPlunge(plunged), 0.5 + 0.2 + 1e-9);
    EXPECT_LT(plunged.totals.time_s(), 60);
    expectSound(plunged, deepHole(), 2);
}

TEST(WayDown, IsAHelixWhereTheToolMayNotPlunge) {
    for (const double max_plunge_mm : {0.0, 0.05}) {
        const Toolpath helix = inHole(max_plunge_mm);
        EXPECT_EQ(deepestPlunge(helix), 0);
        EXPECT_GT(helix.totals.time_s(), 60);
    }
}

// 5 degrees are 0.5 mm a turn of that ring, the plunge feed allows 0.7: less than a depth of cut.
TEST(WayDown, IsASteepHelixWhereThatIsQuickerThanPlunges) {
    const double plunge_feed = 60;
    const Toolpath path = inHole(2, plunge_feed);
    expectSound(path, deepHole(), 2);
    EXPECT_EQ(deepestPlunge(path), 0);
    EXPECT_LT(path.totals.time_s(), inHole(0, plunge_feed).totals.time_s() / 1.5);
    const double turn_mm = 2 * kPi;  // of the ring that a cutter of 4 mm goes along in a hole of 6
    double steepest = 0;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        if (move.kind == MoveKind::Ramp) {
            const double flat_mm = length(Vec2(from.head<2>()), {Vec2(move.to.head<2>()), move.arc});
            const double slope = (from.z() - move.to.z()) / flat_mm;
            steepest = std::max(steepest, slope);
            EXPECT_LE(slope * turn_mm, path.step_down_mm + 1e-3);  // arcs are on the grid
            EXPECT_LE(path.feedOf(move) * slope / std::hypot(1, slope), plunge_feed);
            // Rated removal; a turn takes a disc of 3 mm radius.
            EXPECT_LE(path.feedOf(move) * slope * kPi * 3 * 3, 1.2 * 1.6 * 520 * 1.001);
        }
        from = move.to;
    }
    EXPECT_GT(steepest * turn_mm, 0.6);
}

/// How a hole of 20 mm is gone down: how often the cutter comes out of it, and how much deeper it gets from
/// one time to the next, but for the first.
struct WayInto {
    int lifts = 0;
    double deepest_mm = 0;
};
WayInto wayInto(double hole_radius_mm) {
    const Region hole = makeCircle({0, 0}, hole_radius_mm);
    ClearingTask task = fullTask(hole, blockAround(hole, {}, kTol), 2, kTol);
    task.floor_z_mm = -20;
    ToolAssembly tool = flatEndMill(4);
    tool.max_plunge_mm = 2;
    CuttingData cutting = cuttingData(1.2, 1.6);
    cutting.plunge_feed_mm_per_min = 300;
    const Toolpath path = clearArea(task, tool, cutting, kMachine, kTol);
    expectSound(path, task, 2);
    WayInto found;
    double low_mm = task.top_z_mm;
    double low_at_lift_mm = low_mm;
    for (std::size_t i = 0; i + 1 < path.moves.size(); ++i) {
        low_mm = std::min(low_mm, path.moves[i].to.z());
        if (path.moves[i].to.z() < task.retract_z_mm || low_mm >= low_at_lift_mm) continue;
        if (found.lifts++ > 0) found.deepest_mm = std::max(found.deepest_mm, low_at_lift_mm - low_mm);
        low_at_lift_mm = low_mm;
    }
    return found;
}

TEST(WayDown, ComesOutOfANarrowHoleForItsChips) {
    const WayInto narrow = wayInto(2.2);
    EXPECT_GE(narrow.lifts, 3);
    EXPECT_LE(narrow.deepest_mm, 4 + 1.6);
    EXPECT_EQ(wayInto(3).lifts, 0) << "beside the cutter there is room";
}

TEST(Patterns, OfGroundThatOneRingClearsAreThatRing) {
    const Toolpath path = inHole(2);
    ASSERT_EQ(path.regions.size(), 1U);
    EXPECT_EQ(path.regions.front().weighed.size(), 1U);
    EXPECT_EQ(path.regions.front().weighed.front().pattern, Pattern::ContourInsideOut);
}

TEST(WayDown, TakesDepthsOfCutThatItMayPlungeWhereThereIsNoOther) {
    const Region hole = makeCircle({0, 0}, 2.01);
    ClearingTask task = fullTask(hole, blockAround(hole, {}, kTol), 2, kTol);
    task.entries.front() = {EntryKind::Plunge, Vec2(0, 0), 0, Vec2::Zero()};
    ToolAssembly tool = flatEndMill(4);
    tool.max_plunge_mm = 1.5;
    const Toolpath path = clearArea(task, tool, cuttingData(1.2, 3), kMachine, kTol);
    EXPECT_EQ(path.depths, 4);
    EXPECT_LE(deepestPlunge(path), 1.5 + 0.2 + 1e-9);
}

/// A pocket with room for several rings.
ClearingTask pocket() {
    const Region outline = makeRoundedRectangle({0, 0}, {70, 50}, 6);
    ClearingTask task = fullTask(outline, blockAround(outline, {}, kTol), 5, kTol);
    task.floor_z_mm = -12;
    return task;
}

TEST(FirstRing, IsCutDownToTheFloorBeforeTheOthers) {
    ClearingTask task = pocket();
    const Toolpath at_once = clearArea(task, flatEndMill(10), cuttingData(5, 4), kMachine, kTol);
    expectSound(at_once, task, 5);
    task.free_reach_mm = 6;  // shank or holder would meet the rings that still stand
    const Toolpath by_depths = clearArea(task, flatEndMill(10), cuttingData(5, 4), kMachine, kTol);
    expectSound(by_depths, task, 5);
    EXPECT_LT(at_once.totals.time_s(), by_depths.totals.time_s() - 2);
    const auto firstAtFloor = [&](const Toolpath& path) {
        const auto found = std::find_if(path.moves.begin(), path.moves.end(),
                                        [&](const Move& move) { return move.to.z() <= task.floor_z_mm; });
        return static_cast<double>(found - path.moves.begin()) / static_cast<double>(path.moves.size());
    };
    EXPECT_LT(firstAtFloor(at_once), 0.5);
    EXPECT_GT(firstAtFloor(by_depths), 0.6);
}

TEST(WayOut, LeavesTheWallBeforeTheCutterRises) {
    const ClearingTask task = pocket();
    const Toolpath path = clearArea(task, flatEndMill(10), cuttingData(5, 4), kMachine, kTol);
    Vec3 from = path.start;
    int rises = 0;
    for (const Move& move : path.moves) {
        const bool rises_from_depth =
            move.kind == MoveKind::Rapid && move.to.z() > from.z() && from.z() < task.top_z_mm;
        if (rises_from_depth) {
            ++rises;
            EXPECT_GT(distanceToBoundary(task.target, Vec2(from.head<2>())), 5 + 0.3) << from.transpose();
        }
        from = move.to;
    }
    EXPECT_GT(rises, 0);
}

}  // namespace
}  // namespace stepmill
