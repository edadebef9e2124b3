// Clearing whole targets: coverage, walls, lengths, layers, entries.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"
#include "support/clearing_tasks.h"
#include "support/sound_path.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using namespace test;

constexpr double kCellMm = 0.1;
constexpr double kMarginMm = 0.15;

using test::kMachine;
using test::kTol;

/// 70 x 50, corner radius 6, island of diameter 16 in the middle.
Region pocketWithIsland() {
    Region pocket = makeRoundedRectangle({0, 0}, {70, 50}, 6);
    pocket.loops.push_back(reversed(makeCircle({35, 25}, 8).loops.front()));
    return pocket;
}

class PocketWithIsland : public testing::TestWithParam<double> {};

TEST_P(PocketWithIsland, IsClearedToTheWallsByAnyTool) {
    const double r = GetParam() / 2;
    const Region target = pocketWithIsland();
    const ClearingTask task = fullTask(target, blockAround(target, {}, kTol), r, kTol);
    const Toolpath path = clearArea(task, flatEndMill(2 * r), cuttingData(r, 4), kMachine, kTol);
    EXPECT_EQ(path.depths, 2);
    expectSound(path, task, r);
    // The passes along the walls keep no more than the guard.
    EXPECT_LT(prove(path, task, r, kTol).least_clearance_mm, 2 * kTol.guard_mm);
}

INSTANTIATE_TEST_SUITE_P(Diameters, PocketWithIsland, testing::Values(3.0, 6.0, 8.0, 10.0, 12.0, 16.0, 20.0));

TEST(ClearArea, GivesNoMovesWhenTheToolFitsNowhere) {
    const Region slot = makeRectangle({0, 0}, {50, 8});
    // A slot exactly as wide as the cutter is not passable by the planar kernel's rule for ties.
    const ClearingTask task = fullTask(slot, blockAround(slot, {}, kTol), 4, kTol);
    EXPECT_TRUE(clearArea(task, flatEndMill(8), cuttingData(4, 4), kMachine, kTol).moves.empty());
}

TEST(ClearArea, RunsThroughASlotALittleWiderThanTheCutter) {
    const Region slot = makeRoundedRectangle({0, 0}, {50, 8.1}, 4.05);
    const ClearingTask task = fullTask(slot, blockAround(slot, {}, kTol), 4, kTol);
    expectSound(clearArea(task, flatEndMill(8), cuttingData(3, 4), kMachine, kTol), task, 4);
}

TEST(ClearArea, ComesInOverTheOpenEndOfASlot) {
    const Region slot = makeRectangle({0, 0}, {60, 20});
    const Region open = makeRectangle({-40, -1}, {0, 21});
    const ClearingTask task = fullTask(slot, blockAround(slot, open, kTol), 5, kTol);
    ASSERT_EQ(task.entries.size(), 1U);
    EXPECT_EQ(task.entries.front().kind, EntryKind::OpenEdge);
    const Toolpath path = clearArea(task, flatEndMill(10), cuttingData(4, 2), kMachine, kTol);
    expectSound(path, task, 5);
    // Every descent is in air: nothing has to be plunged into.
    for (const Move& move : path.moves)
        EXPECT_TRUE(move.kind != MoveKind::Ramp && (move.kind != MoveKind::Plunge || move.in_air));
}

TEST(ClearArea, GoesAlongAWallThatALargerCutterReachedInItsMiddle) {
    // What another cutter cleared comes up to the wall in one place; there a smaller disc only touches what
    // is left.
    const Region cleared = makeCircle({10, 1 - 1.5 * kTol.guard_mm}, 5);
    const Region target = subtract(makeRectangle({0, 0}, {20, 6}), cleared, kTol);
    const Region boss = makeRectangle({0, 6}, {20, 16});
    const ClearingTask task = fullTask(target, boss, 4, kTol);
    for (const Pattern pattern : {Pattern::ContourInsideOut, Pattern::Zigzag, Pattern::OneWay}) {
        ClearingTask by = task;
        by.pattern = pattern;
        expectSound(clearArea(by, flatEndMill(8), cuttingData(3.6, 6), kMachine, kTol), by, 4);
    }
}

TEST(ClearArea, CutsANotchInClearedGroundThatRunsAlongTheWall) {
    // The cleared ground keeps nearer to the wall's ring than is told apart and crosses it nowhere.
    constexpr double kHardlyOffMm = 6e-4;
    const Region pocket = makeRectangle({0, 0}, {60, 30});
    const Region notch = makeRectangle({10, 0}, {18, 10});
    for (const Pattern pattern : {Pattern::ContourInsideOut, Pattern::Zigzag}) {
        ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 4, kTol);
        task.cleared_centres = subtract(offset(task.free_centres, -kHardlyOffMm, kTol), notch, kTol);
        task.centres = intersect(task.free_centres, notch, kTol);
        task.pattern = pattern;
        bool cuts_along_wall = false;
        for (const Move& move : clearArea(task, flatEndMill(8), cuttingData(3.6, 6), kMachine, kTol).moves)
            cuts_along_wall =
                cuts_along_wall || (move.kind == MoveKind::Feed && move.to.z() == task.floor_z_mm &&
                                    move.to.y() < 4.1 && contains(notch, move.to.head<2>()));
        EXPECT_TRUE(cuts_along_wall);
    }
}

TEST(ClearArea, StaysBelowTheTopBetweenDepthsOfAPocket) {
    const Region pocket = makeRoundedRectangle({0, 0}, {50, 40}, 6);
    const ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 5, kTol);
    const Toolpath path = clearArea(task, flatEndMill(10), cuttingData(4, 2), kMachine, kTol);
    ASSERT_EQ(path.depths, 3);
    expectSound(path, task, 5);
    int at_retract = 0;
    for (const Move& move : path.moves)
        at_retract += move.to.z() == task.retract_z_mm ? 1 : 0;
    EXPECT_EQ(at_retract, 1) << "the last move alone goes up to the retract height";
}

TEST(ClearArea, BoresAHoleAsOneHelixAndALevelTurn) {
    const Region hole = makeCircle({0, 0}, 6);
    const ClearingTask task = fullTask(hole, blockAround(hole, {}, kTol), 4, kTol);
    const Toolpath path = clearArea(task, flatEndMill(8), cuttingData(4, 2), kMachine, kTol);
    ASSERT_EQ(path.depths, 3);
    expectSound(path, task, 4);
    const double helix_mm = 6.2 / std::sin(degToRad(3));
    EXPECT_NEAR(path.totals.cut_length_mm, 0.8 + helix_mm + 2 * kPi * 2 + 0.5, 0.02) << "and off the wall";
    for (const Move& move : path.moves)
        EXPECT_TRUE(move.kind != MoveKind::Feed || move.to.z() == -6);
}

TEST(ClearArea, GoesRoundALongRingOnceADepthAndLevelsItsLastRamp) {
    const Region pocket = makeRoundedRectangle({0, 0}, {80, 14}, 6);
    const ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 5, kTol);
    const Toolpath path = clearArea(task, flatEndMill(10), cuttingData(4, 2), kMachine, kTol);
    expectSound(path, task, 5);
    const double ring_mm = perimeter(task.free_centres);
    const double ramp_mm = 2.2 / std::tan(degToRad(3));
    EXPECT_NEAR(path.totals.cut_length_mm, 3 * ring_mm + ramp_mm, 1.5);
}

TEST(ClearArea, LeavesOutAnInnermostRingThatTheNextOneCovers) {
    // Centres of 74 x 9.8: the ring one step-over in would be 0.8 wide, and the cutter is 10.
    const Region pocket = makeRoundedRectangle({0, 0}, {84, 19.8}, 5.5);
    const ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 5, kTol);
    const Toolpath path = clearArea(task, flatEndMill(10), cuttingData(4.5, 6), kMachine, kTol);
    expectSound(path, task, 5);
    for (const Path& chain : topView(path))
        for (const Segment& segment : chain.segments)
            EXPECT_NEAR(distanceToBoundary(pocket, segment.to), 5, 0.01);
}

TEST(ClearArea, GoesOverTheRetractHeightBetweenPockets) {
    const Region pockets =
        unite(makeRoundedRectangle({0, 0}, {30, 40}, 6), makeRoundedRectangle({40, 0}, {70, 40}, 6), kTol);
    const ClearingTask task = fullTask(pockets, blockAround(pockets, {}, kTol), 5, kTol);
    const Toolpath path = clearArea(task, flatEndMill(10), cuttingData(4, 6), kMachine, kTol);
    expectSound(path, task, 5);
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const bool across = (from.x() < 35) != (move.to.x() < 35);
        EXPECT_TRUE(!across || std::min(from.z(), move.to.z()) >= task.retract_z_mm);
        from = move.to;
    }
}

TEST(ClearArea, MachinesAStepNarrowerThanTheCutterFromOutside) {
    const Region step = makeRectangle({0, 0}, {60, 4});
    const Region open = makeRectangle({-40, 0}, {100, 40});
    const Region sides = makeRectangle({-40, 0}, {100, 4});
    const ClearingTask task = fullTask(step, blockAround(step, unite(open, sides, kTol), kTol), 6, kTol);
    const Toolpath path = clearArea(task, flatEndMill(12), cuttingData(3, 4), kMachine, kTol);
    expectSound(path, task, 6);
}

TEST(ClearArea, CutsAStepFromTheOpenSideTowardsTheWallOneStepOverAtATime) {
    const Region step = makeRectangle({0, 0}, {60, 10});
    const Region open = makeRectangle({-40, 0}, {100, 50});
    ClearingTask task = fullTask(step, blockAround(step, open, kTol), 5, kTol);
    task.pattern = Pattern::ContourInsideOut;
    const Toolpath path = clearArea(task, flatEndMill(10), cuttingData(4, 10), kMachine, kTol);
    expectSound(path, task, 5);
    double last_y = 100;
    int passes = 0;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const bool pass = move.kind == MoveKind::Feed && std::abs(move.to.x() - from.x()) > 50;
        if (pass) {
            // Climb milling with a right-handed spindle: the wall, at y = 0, is on the right.
            EXPECT_GT(move.to.x(), from.x());
            EXPECT_LT(move.to.y(), last_y - 3.9);
            last_y = move.to.y();
            ++passes;
        }
        from = move.to;
    }
    EXPECT_EQ(passes, 3);  // 13, 9 and 5 mm from the wall
    EXPECT_NEAR(last_y, 5, 1e-3);
}

TEST(ClearArea, ClearsAFaceFromOutsideIn) {
    const Region face = makeRectangle({0, 0}, {80, 50});
    ClearingTask task = fullTask(face, {}, 10, kTol);
    const Toolpath path = clearArea(task, flatEndMill(20), cuttingData(8, 10), kMachine, kTol);
    const SimulatedCut cut = simulate(path, task, 10, kCellMm, kMarginMm);
    EXPECT_EQ(cut.left_mm2, 0);
    EXPECT_EQ(cut.bad_rapids, 0);
    for (const Move& move : path.moves)
        EXPECT_TRUE(move.kind != MoveKind::Plunge || move.in_air) << "a face is entered from its side";
    // The first ring is the longest.
    double first = 0;
    double longest = 0;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const double run = (move.to - from).norm();
        if (move.kind == MoveKind::Feed && !move.arc && !move.in_air && run > 20) {
            if (first == 0) first = run;
            longest = std::max(longest, run);
        }
        from = move.to;
    }
    EXPECT_GE(first, 40);
    EXPECT_LE(first, longest);
}

TEST(ClearArea, HasTheLengthOfItsRingsInASquarePocket) {
    // Centres: 40 x 40; rings of side 40, 32, ..., 8 with the step-over 4; links of 4 between them.
    const Region pocket = makeRectangle({0, 0}, {50, 50});
    ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 5, kTol);
    task.entries.front() = {EntryKind::Plunge, Vec2(25, 25), 0, Vec2::Zero()};
    task.floor_z_mm = -2;
    task.pattern = Pattern::ContourInsideOut;
    const Toolpath path = clearArea(task, flatEndMill(10), cuttingData(4, 2), kMachine, kTol);
    double rings = 0;
    for (const double side : {40.0, 32.0, 24.0, 16.0, 8.0})
        rings += 4 * side;
    const double links = 4 + 4 * 4;       // from the middle to the first ring, then from ring to ring
    const double plunge = 2 + 0.2 + 0.8;  // the depth and the approach above it
    const double off_wall = 0.5;
    EXPECT_NEAR(path.totals.cut_length_mm, rings + links + plunge + off_wall, 0.02);
    EXPECT_NEAR(path.totals.feed_air_length_mm, 0.8 + off_wall, 1e-6);
    EXPECT_NEAR(path.totals.feed_time_s, (rings + links + off_wall) / 1000 * 60 + plunge / 300 * 60, 0.01);
    // Down to 1 mm over the top, and up again.
    EXPECT_NEAR(path.totals.air_length_mm, 4 + 7, 1e-9);
    EXPECT_NEAR(path.totals.rapid_time_s, 11.0 / 5000 * 60, 1e-9);
}

TEST(ClearArea, DividesTheDepthEvenly) {
    const Region pocket = makeRectangle({0, 0}, {40, 40});
    ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 5, kTol);
    task.floor_z_mm = -10;
    const auto layers = [&](double step_down) {
        const Toolpath path = clearArea(task, flatEndMill(10), cuttingData(4, step_down), kMachine, kTol);
        std::set<double> levels;
        Vec3 from = path.start;
        for (const Move& move : path.moves) {
            if (move.kind == MoveKind::Feed) levels.insert(move.to.z());
            from = move.to;
        }
        EXPECT_EQ(static_cast<int>(levels.size()), path.depths);
        EXPECT_EQ(*levels.begin(), -10);
        EXPECT_NEAR(path.step_down_mm * path.depths, 10, 1e-12);
        return path.depths;
    };
    EXPECT_EQ(layers(4), 3);
    EXPECT_EQ(layers(2.5), 4);
    EXPECT_EQ(layers(10.0 / 3 - 1e-12), 3);
    EXPECT_EQ(layers(20), 1);
}

TEST(ClearArea, KeepsTheWallOnTheRight) {
    const Region pocket = makeRectangle({0, 0}, {40, 40});
    const ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 5, kTol);
    const Toolpath path = clearArea(task, flatEndMill(10), cuttingData(4, 10), kMachine, kTol);
    int along_walls = 0;
    for (const Path& chain : topView(path)) {
        for (const auto& [from, segment] : eachEdge(chain)) {
            const Vec2 middle = pointAt(from, segment, 0.5);
            if (std::abs(distanceToBoundary(pocket, middle) - 5) < 1e-2 && length(from, segment) > 5) {
                const Vec2 along = tangentAt(from, segment, 0.5);
                EXPECT_FALSE(contains(pocket, middle + 6 * Vec2(along.y(), -along.x())));
                ++along_walls;
            }
        }
    }
    EXPECT_GE(along_walls, 4);
}

TEST(ClearArea, KeepsArcsAsArcs) {
    const Region pocket = makeCircle({0, 0}, 30);
    const ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 5, kTol);
    const Toolpath path = clearArea(task, flatEndMill(10), cuttingData(4, 10), kMachine, kTol);
    expectSound(path, task, 5);
    // Rings of radius 25, 21, ..., 1: seven circles, each three arcs at most, the helix and the links.
    EXPECT_LT(path.moves.size(), 7 * 4 + 30U);
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        EXPECT_TRUE(!move.arc || from.head<2>() != move.to.head<2>()) << "a full circle is two halves";
        from = move.to;
    }
}

TEST(ClearArea, HasNoMovesWithoutLength) {
    const Region target = pocketWithIsland();
    const ClearingTask task = fullTask(target, blockAround(target, {}, kTol), 4, kTol);
    const Toolpath path = clearArea(task, flatEndMill(8), cuttingData(3, 4), kMachine, kTol);
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        EXPECT_GT((move.to - from).norm(), 0);
        from = move.to;
    }
    EXPECT_EQ(path.start.z(), task.retract_z_mm);
    EXPECT_EQ(from.z(), task.retract_z_mm);
}

TEST(ClearArea, GivesTheSamePathTwice) {
    const Region target = pocketWithIsland();
    const ClearingTask task = fullTask(target, blockAround(target, {}, kTol), 4, kTol);
    const auto make = [&] { return clearArea(task, flatEndMill(8), cuttingData(3, 4), kMachine, kTol); };
    const Toolpath a = make();
    const Toolpath b = make();
    ASSERT_EQ(a.moves.size(), b.moves.size());
    for (std::size_t i = 0; i < a.moves.size(); ++i) {
        EXPECT_EQ(a.moves[i].to, b.moves[i].to);
        EXPECT_EQ(a.moves[i].arc, b.moves[i].arc);
        EXPECT_EQ(a.moves[i].kind, b.moves[i].kind);
    }
}

TEST(ClearArea, GivesTheSamePathWithSharedRings) {
    const Region target = pocketWithIsland();
    ClearingTask task = fullTask(target, blockAround(target, {}, kTol), 4, kTol);
    const CuttingData cutting = cuttingData(3, 4);
    const Toolpath own = clearArea(task, flatEndMill(8), cutting, kMachine, kTol);
    task.rings = makeRings(task, flatEndMill(8), cutting, kTol);
    const Toolpath shared = clearArea(task, flatEndMill(8), cutting, kMachine, kTol);
    ASSERT_EQ(own.moves.size(), shared.moves.size());
    for (std::size_t i = 0; i < own.moves.size(); ++i)
        EXPECT_EQ(own.moves[i].to, shared.moves[i].to);
}

TEST(ClearArea, RefusesRingsOfAnotherTool) {
    const Region target = pocketWithIsland();
    ClearingTask task = fullTask(target, blockAround(target, {}, kTol), 4, kTol);
    task.rings = makeRings(task, flatEndMill(6), cuttingData(3, 4), kTol);
    EXPECT_THROW(clearArea(task, flatEndMill(8), cuttingData(3, 4), kMachine, kTol), Error);
}

class DescentThroughMaterial : public testing::TestWithParam<EntryKind> {};

TEST_P(DescentThroughMaterial, IsNoSteeperThanTheRampAngleUnlessPlunging) {
    const Region pocket = makeRoundedRectangle({0, 0}, {50, 30}, 6);
    ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 5, kTol);
    Entry entry{GetParam(), Vec2(20, 15), 0, Vec2::Zero()};
    if (GetParam() == EntryKind::Helix) entry.helix_radius_mm = 3;
    if (GetParam() == EntryKind::Ramp) entry.ramp_to = Vec2(30, 15);
    task.entries.front() = entry;
    const Toolpath path = clearArea(task, flatEndMill(10), cuttingData(4, 3), kMachine, kTol);
    expectSound(path, task, 5);
    Vec3 from = path.start;
    double steepest = 0;
    for (const Move& move : path.moves) {
        if (move.kind == MoveKind::Ramp || (move.kind == MoveKind::Plunge && !move.in_air)) {
            const double flat = length(Vec2(from.head<2>()), Segment{move.to.head<2>(), move.arc});
            steepest = std::max(steepest, std::atan2(from.z() - move.to.z(), flat));
        }
        EXPECT_TRUE(move.kind != MoveKind::Feed || from.z() == move.to.z());
        from = move.to;
    }
    const bool plunges = GetParam() == EntryKind::Plunge;
    EXPECT_NEAR(steepest, plunges ? kPi / 2 : 0, plunges ? 1e-9 : degToRad(3) + 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Kinds, DescentThroughMaterial,
                         testing::Values(EntryKind::Helix, EntryKind::Ramp, EntryKind::Plunge));

TEST(ClearArea, RampsAlongThePassWhereTheEntryHasNoRoom) {
    const Region slot = makeRoundedRectangle({0, 0}, {50, 8.1}, 4.05);
    ClearingTask task = fullTask(slot, blockAround(slot, {}, kTol), 4, kTol);
    task.entries.front() = {EntryKind::Helix, Vec2(25, 4.05), 0.05, Vec2::Zero()};
    const Toolpath path = clearArea(task, flatEndMill(8), cuttingData(3, 4), kMachine, kTol);
    expectSound(path, task, 4);
}

}  // namespace
}  // namespace stepmill
