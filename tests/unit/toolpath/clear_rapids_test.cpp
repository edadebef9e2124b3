#include <algorithm>
#include <optional>

#include <gtest/gtest.h>

#include "support/clearing_tasks.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using namespace test;

constexpr double kRadiusMm = 5;
constexpr double kSideMm = 2;
constexpr double kInsideMm = 0.5;
constexpr double kTopMm = 2;
using test::kTol;

Machine carefulMachine() {
    Machine machine = machineWithRapid(5000);
    machine.side_clearance_mm = kSideMm;
    machine.inside_clearance_mm = kInsideMm;
    machine.top_clearance_mm = kTopMm;
    return machine;
}

/// A slot of 30 mm that is open to the right of x = 60, 6 mm deep, with a skirt beside its mouth.
ClearingTask slot() {
    const Region target = makeRectangle(Vec2(0, 0), Vec2(60, 30));
    const Region block = makeRectangle(Vec2(-20, -20), Vec2(60, 50));
    ClearingTask task = fullTask(target, subtract(block, target, kTol), kRadiusMm, kTol);
    task.skirt =
        unite(makeRectangle(Vec2(60, -20), Vec2(60.5, 0)), makeRectangle(Vec2(60, 30), Vec2(60.5, 50)), kTol);
    task.stands_to_mm = 0;
    return task;
}

/// Down by a rapid at a place, and on to another at depth.
Toolpath pathFrom(const Vec2& at, const Vec2& to) {
    Toolpath path;
    path.start = {at.x(), at.y(), 5};
    path.feed_mm_per_min = 1000;
    path.plunge_feed_mm_per_min = 200;
    path.moves = {{MoveKind::Rapid, {at.x(), at.y(), -6}, std::nullopt, false},
                  {MoveKind::Feed, {to.x(), to.y(), -6}, std::nullopt, false},
                  {MoveKind::Rapid, {to.x(), to.y(), 5}, std::nullopt, false}};
    return path;
}

double lowestRapid(const Toolpath& path) {
    double lowest = path.start.z();
    for (const Move& move : path.moves)
        if (move.kind == MoveKind::Rapid) lowest = std::min(lowest, move.to.z());
    return lowest;
}

/// Least distance of falling and level rapids under the top from a region.
double rapidsFrom(const Toolpath& path, const Region& region) {
    double least = 1e9;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const bool looks = move.kind == MoveKind::Rapid && move.to.z() <= from.z() && move.to.z() < 0;
        if (looks) least = std::min(least, distanceToRegion(region, Vec2(move.to.head<2>())) - kRadiusMm);
        from = move.to;
    }
    return least;
}

TEST(WithClearRapids, ComesDownAsFarBesideTheMaterialAsTheMachineSays) {
    const ClearingTask task = slot();
    const Toolpath path =
        withClearRapids(pathFrom({65.001, 15}, {30, 15}), task, kRadiusMm, carefulMachine());
    EXPECT_GE(rapidsFrom(path, task.target), kSideMm - 1e-3);
    EXPECT_GE(rapidsFrom(path, task.skirt), kInsideMm - 1e-3);
    EXPECT_DOUBLE_EQ(lowestRapid(path), -6) << "there is room for a rapid to the floor";
    EXPECT_EQ(path.moves.back().to, Vec3(30, 15, 5));
}

TEST(WithClearRapids, IsFedDownWhereNoPlaceIsClear) {
    // The middle of solid ground: a rapid there was believed to fall into a hole.
    const Toolpath path = withClearRapids(pathFrom({30, 15}, {40, 15}), slot(), kRadiusMm, carefulMachine());
    EXPECT_DOUBLE_EQ(lowestRapid(path), kTopMm);
}

/// The path with a glide straight down, and its height; nothing without one.
std::optional<double> glideTo(const Toolpath& path) {
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        if (isGlide(move) && move.to.head<2>() == from.head<2>() && move.to.z() < from.z())
            return move.to.z();
        from = move.to;
    }
    return std::nullopt;
}

/// A pocket that leaves the cutter `room_mm` on either side, cut to the floor before.
ClearingTask clearedPocket(double room_mm) {
    const double half_mm = kRadiusMm + room_mm;
    const Region target = makeRectangle(Vec2(-half_mm, -half_mm), Vec2(half_mm, half_mm));
    ClearingTask task = fullTask(target, subtract(makeRectangle(Vec2(-50, -50), Vec2(50, 50)), target, kTol),
                                 kRadiusMm, kTol);
    task.cleared_centres = task.free_centres;
    return task;
}

TEST(WithClearRapids, GlidesDownWhereTheCutterHasRoomButNoRapid) {
    const Toolpath path =
        withClearRapids(pathFrom({0, 0}, {0.1, 0}), clearedPocket(0.3), kRadiusMm, carefulMachine());
    EXPECT_GE(lowestRapid(path), kTopMm);
    ASSERT_TRUE(glideTo(path));
    EXPECT_DOUBLE_EQ(*glideTo(path), -6);
    EXPECT_FALSE(glideTo(withClearRapids(pathFrom({30, 15}, {40, 15}), slot(), kRadiusMm, carefulMachine())))
        << "into solid ground";
}

TEST(WithClearRapids, GoesDownAsFastAsItCutsBesideAWall) {
    const Toolpath path =
        withClearRapids(pathFrom({0, 0}, {0.01, 0}), clearedPocket(0.02), kRadiusMm, carefulMachine());
    const auto glide = std::find_if(path.moves.begin(), path.moves.end(), isGlide);
    ASSERT_NE(glide, path.moves.end());
    EXPECT_DOUBLE_EQ(glide->feed_mm_per_min, 1000);
}

TEST(WithClearRapids, KeepsOffWallsOverGroundThatIsCut) {
    ClearingTask task = slot();
    task.cleared_centres = task.free_centres;
    const Toolpath path = withClearRapids(pathFrom({5.001, 15}, {30, 15}), task, kRadiusMm, carefulMachine());
    EXPECT_GE(rapidsFrom(path, task.obstruction), kInsideMm - 1e-3);
    EXPECT_DOUBLE_EQ(lowestRapid(path), -6);
}

TEST(WithClearRapids, GoesNoLowerOverARawTopThanTheClearance) {
    Toolpath path = pathFrom({70, 15}, {30, 15});
    path.moves.insert(path.moves.begin() + 2, {{MoveKind::Rapid, {30, 15, 1}, std::nullopt, false},
                                               {MoveKind::Rapid, {70, 15, 1}, std::nullopt, false},
                                               {MoveKind::Rapid, {70, 15, -6}, std::nullopt, false},
                                               {MoveKind::Feed, {30, 20, -6}, std::nullopt, false}});
    path.moves.back().to = {30, 20, 5};
    const Toolpath clear = withClearRapids(path, slot(), kRadiusMm, carefulMachine());
    Vec3 from = clear.start;
    for (const Move& move : clear.moves) {
        const bool across = move.kind == MoveKind::Rapid && move.to.head<2>() != from.head<2>();
        EXPECT_TRUE(!across || move.to.z() >= kTopMm);
        from = move.to;
    }
}

TEST(WithClearRapids, GoAcrossHigherWhereALandingBesideLeadsThemTooNearToAWall) {
    // Just over the target the straight way between the two places is clear; landing beside them, between the
    // post and the step, turns it into the post.
    const Region target = makeRectangle(Vec2(0, 0), Vec2(60, 30));
    const Region stand =
        unite(makeRectangle(Vec2(18, 20.05), Vec2(20, 30)), makeRectangle(Vec2(26, 0), Vec2(60, 9.7)), kTol);
    ClearingTask task =
        fullTask(subtract(target, stand, kTol), unite(slot().obstruction, stand, kTol), kRadiusMm, kTol);
    task.cleared_centres = task.free_centres;
    task.stands_to_mm = 0;
    const Toolpath path = pathFrom({12, 15}, {28, 15});
    const Toolpath clear = withClearRapids(path, task, kRadiusMm, carefulMachine());
    EXPECT_TRUE(prove(clear, task, kRadiusMm, kTol).rapids_clear);
    EXPECT_GE(prove(clear, task, kRadiusMm, kTol).least_clearance_mm, -kTol.gouge_mm);
}

TEST(WithClearRapids, GoDownToANarrowFeatureInAWideOne) {
    const auto square = [](double half_mm) {
        return makeRectangle(Vec2(-half_mm, -half_mm), Vec2(half_mm, half_mm));
    };
    const Region block = square(100);
    const double narrow_mm = kRadiusMm + kInsideMm / 2;
    ClearingTask task =
        fullTask(square(narrow_mm), subtract(block, square(narrow_mm), kTol), kRadiusMm, kTol);
    task.stands_to_mm = 40;
    task.retract_z_mm = 45;
    Toolpath path = pathFrom({0, 0}, {0, 0});
    path.start.z() = path.moves.back().to.z() = task.retract_z_mm;
    const auto lowest = [&](std::optional<Region> above) {
        task.stands_above = std::move(above);
        const Toolpath clear = withClearRapids(path, task, kRadiusMm, carefulMachine());
        EXPECT_TRUE(prove(clear, task, kRadiusMm, kTol).rapids_clear);
        double lowest_mm = task.retract_z_mm;
        for (const Move& move : clear.moves)
            if (move.kind == MoveKind::Rapid) lowest_mm = std::min(lowest_mm, move.to.z());
        return lowest_mm;
    };
    EXPECT_GT(lowest(std::nullopt), task.stands_to_mm);
    EXPECT_GT(lowest(subtract(block, square(kRadiusMm + 0.8 * kInsideMm), kTol)), task.stands_to_mm);
    EXPECT_NEAR(lowest(subtract(block, square(20), kTol)), kTopMm, 1e-9);
}

TEST(WithClearRapids, GlidesDownNowhereThatStockMayBeLarger) {
    ClearingTask task = clearedPocket(0.3);
    EXPECT_TRUE(glideTo(withClearRapids(pathFrom({0, 0}, {0.1, 0}), task, kRadiusMm, carefulMachine())));
    task.skirt = makeRectangle(Vec2(kRadiusMm - 0.2, -1), Vec2(kRadiusMm + 0.3, 1));
    EXPECT_FALSE(glideTo(withClearRapids(pathFrom({0, 0}, {0.1, 0}), task, kRadiusMm, carefulMachine())));
}

TEST(WithClearRapids, OfAMachineWithoutClearancesAreAsTheyWere) {
    ClearingTask task = slot();
    task.skirt = {};
    const Toolpath path = pathFrom({65, 15}, {30, 15});
    EXPECT_EQ(withClearRapids(path, task, kRadiusMm, machineWithRapid(5000)).moves.size(), path.moves.size());
}

TEST(ClearArea, KeepsRapidsOffTheSkirtAndTheTarget) {
    const ClearingTask task = slot();
    CuttingData cutting;
    cutting.feed_mm_per_min = 1000;
    cutting.plunge_feed_mm_per_min = 200;
    cutting.step_over_mm = 3;
    cutting.step_down_mm = 2;
    ToolAssembly tool;
    tool.diameter_mm = 2 * kRadiusMm;
    const Toolpath path = clearArea(task, tool, cutting, carefulMachine(), kTol);
    ASSERT_FALSE(path.moves.empty());
    EXPECT_GE(rapidsFrom(path, task.skirt), kInsideMm - 1e-3);
    EXPECT_GE(rapidsFrom(path, task.obstruction), kInsideMm - 1e-3);
    EXPECT_TRUE(prove(path, task, kRadiusMm, kTol).rapids_clear);
}

TEST(Prove, FindsARapidInTheSkirt) {
    ClearingTask task = slot();
    EXPECT_TRUE(prove(pathFrom({65.6, 15}, {30, 15}), task, kRadiusMm, kTol).rapids_clear);
    EXPECT_FALSE(prove(pathFrom({65.1, -10}, {70, -10}), task, kRadiusMm, kTol).rapids_clear);
    task.skirt = {};
    EXPECT_TRUE(prove(pathFrom({65.1, -10}, {70, -10}), task, kRadiusMm, kTol).rapids_clear);
}

}  // namespace
}  // namespace stepmill
