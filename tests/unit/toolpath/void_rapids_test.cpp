#include <gtest/gtest.h>

#include "support/clearing_tasks.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using namespace test;

using test::kTol;

constexpr double kRadiusMm = 5;
constexpr double kInsideMm = 2;
/// From the window's edge to where the rapid begins.
constexpr double kOffMm = kRadiusMm + kInsideMm;

Machine shopMachine() {
    Machine machine = machineWithRapid(15000);
    machine.inside_clearance_mm = kInsideMm;
    return machine;
}

/// A pocket of 100 x 60 mm with a window in its floor from x = 30 to x = 70, and what stands in that.
ClearingTask pocketWithWindow(const Region& in_window = {}) {
    const Region window = makeRectangle(Vec2(30, 10), Vec2(70, 50));
    const Region pocket = makeRectangle(Vec2(0, 0), Vec2(100, 60));
    ClearingTask task;
    task.target = subtract(pocket, window, kTol);
    task.obstruction =
        unite(subtract(makeRectangle(Vec2(-20, -20), Vec2(120, 80)), pocket, kTol), in_window, kTol);
    task.top_z_mm = 0;
    task.floor_z_mm = -4;
    task.retract_z_mm = 5;
    return task;
}

/// At depth from the first point on, the others by feeds.
Toolpath fedThrough(const std::vector<Vec2>& points) {
    Toolpath path;
    path.start = {points.front().x(), points.front().y(), 5};
    path.feed_mm_per_min = 1000;
    path.plunge_feed_mm_per_min = 200;
    for (const Vec2& point : points)
        path.moves.push_back({point == points.front() ? MoveKind::Plunge : MoveKind::Feed,
                              {point.x(), point.y(), -4},
                              std::nullopt});
    path.moves.push_back({MoveKind::Rapid, {points.back().x(), points.back().y(), 5}, std::nullopt});
    path.totals = measure(path, shopMachine());
    return path;
}

std::vector<std::pair<MoveKind, Vec2>> levelMoves(const Toolpath& path) {
    std::vector<std::pair<MoveKind, Vec2>> level;
    for (const Move& move : path.moves)
        if (move.kind == MoveKind::Feed || (move.kind == MoveKind::Rapid && move.to.z() < 0))
            level.emplace_back(move.kind, move.to.head<2>());
    return level;
}

Toolpath crossed(const Toolpath& path, const ClearingTask& task) {
    return withRapidsOverVoids(path, task, kRadiusMm, shopMachine(), kTol);
}

TEST(WithRapidsOverVoids, CrossesTheWindowInARapid) {
    const ClearingTask task = pocketWithWindow();
    const Toolpath path = crossed(fedThrough({{6, 30}, {94, 30}}), task);
    const auto level = levelMoves(path);
    ASSERT_EQ(level.size(), 3U);
    EXPECT_EQ(level[0].first, MoveKind::Feed);
    EXPECT_NEAR(level[0].second.x(), 30 + kOffMm, 1e-5);
    EXPECT_EQ(level[1].first, MoveKind::Rapid);
    EXPECT_NEAR(level[1].second.x(), 70 - kOffMm, 1e-5);
    EXPECT_EQ(level[2].second, Vec2(94, 30));
    EXPECT_NEAR(path.totals.air_length_mm - fedThrough({{6, 30}, {94, 30}}).totals.air_length_mm,
                40 - 2 * kOffMm, 1e-5);
    const PathProof proof = prove(path, task, kRadiusMm, kTol);
    EXPECT_TRUE(proof.rapids_clear);
    EXPECT_GT(proof.least_clearance_mm, 0);
}

TEST(WithRapidsOverVoids, GoesStraightWhereTheFeedsGoRound) {
    const Toolpath path =
        crossed(fedThrough({{6, 25}, {45, 25}, {45, 35}, {55, 35}, {55, 25}, {94, 25}}), pocketWithWindow());
    const auto level = levelMoves(path);
    ASSERT_EQ(level.size(), 3U);
    EXPECT_EQ(level[1].first, MoveKind::Rapid);
    EXPECT_NEAR(level[1].second.y(), 25, 1e-5);
}

TEST(WithRapidsOverVoids, GoesRoundWhatStandsInTheWindow) {
    const ClearingTask task = pocketWithWindow(makeRectangle(Vec2(49, 10), Vec2(51, 28)));
    const Toolpath path =
        crossed(fedThrough({{6, 20}, {38, 20}, {38, 42}, {62, 42}, {62, 20}, {94, 20}}), task);
    const auto level = levelMoves(path);
    ASSERT_EQ(level.size(), 5U);
    EXPECT_EQ(level[1].second, Vec2(38, 42)) << "no way straight across";
    EXPECT_TRUE(prove(path, task, kRadiusMm, kTol).rapids_clear);
}

TEST(WithRapidsOverVoids, LeavesThePathWhereTheVoidIsNoWiderThanTheCutter) {
    ClearingTask task = pocketWithWindow();
    task.target = subtract(makeRectangle(Vec2(0, 0), Vec2(100, 60)), makeCircle({50, 30}, kOffMm), kTol);
    const Toolpath path = fedThrough({{6, 30}, {94, 30}});
    EXPECT_EQ(crossed(path, task).moves.size(), path.moves.size());
}

TEST(WithRapidsOverVoids, IsFedAgainWhereRapidsMayRestOnNothing) {
    const Toolpath path = crossed(fedThrough({{6, 30}, {94, 30}}), pocketWithWindow());
    for (const auto& [kind, to] : levelMoves(withPlainRapids(path, 0, shopMachine())))
        EXPECT_EQ(kind, MoveKind::Feed);
}

}  // namespace
}  // namespace stepmill
