// Rest regions: only what a larger tool has left.

#include <gtest/gtest.h>

#include "support/clearing_tasks.h"
#include "support/raster_simulator.h"
#include "support/sound_path.h"
#include "support/tolerances.h"
#include "toolpath/script/depth_script.h"

namespace stepmill {
namespace {

using namespace test;

using test::kMachine;
using test::kTol;

TEST(RestArea, OfARoundedPocketIsItsFourCorners) {
    const Region pocket = makeRoundedRectangle({0, 0}, {70, 50}, 4);
    const ClearingTask task = restTask(pocket, blockAround(pocket, {}, kTol), 10, 4, kTol);
    const Toolpath path = clearArea(task, flatEndMill(8), cuttingData(3, 10), kMachine, kTol);
    expectSound(path, task, 4);
    // One short pass a corner, nothing along the walls between them: the free centres touch their corner
    // in a point, from which the larger tool's corner arcs (radius 6 for this tool's centre) part.
    EXPECT_EQ(components(task.centres).size(), 4U);
    EXPECT_LT(path.totals.cut_length_mm, 4 * (2 * 6 + 6 + 2.0));
    for (const Move& move : path.moves)
        EXPECT_TRUE(move.kind != MoveKind::Ramp && (move.kind != MoveKind::Plunge || move.in_air))
            << "corners are entered from cleared ground";
}

TEST(RestArea, BehindANeckIsEnteredFromClearedGround) {
    // Two 30 mm squares joined by a neck 10 mm wide; 12 mm cannot pass it.
    const Region target =
        unite(unite(makeRectangle({0, 0}, {30, 30}), makeRectangle({50, 0}, {80, 30}), kTol),
              makeRectangle({25, 10}, {55, 20}), kTol);
    ClearingTask task = restTask(target, blockAround(target, {}, kTol), 6, 4, kTol);
    const Toolpath path = clearArea(task, flatEndMill(8), cuttingData(3, 10), kMachine, kTol);
    expectSound(path, task, 4);
}

TEST(RestArea, IsEmptyWhenTheLargerToolReachesEverything) {
    const Region pocket = makeRoundedRectangle({0, 0}, {70, 50}, 6);
    const ClearingTask task = restTask(pocket, blockAround(pocket, {}, kTol), 6, 3, kTol);
    EXPECT_TRUE(clearArea(task, flatEndMill(6), cuttingData(3, 10), kMachine, kTol).moves.empty());
}

TEST(RestArea, IsCutHoweverThinWhereItIsMoreThanASkin) {
    // In every corner the larger tool leaves a crescent 20 um thick, less than a hundredth of the radius.
    const Region pocket = makeRoundedRectangle({0, 0}, {70, 50}, 5.95);
    const ClearingTask task = restTask(pocket, blockAround(pocket, {}, kTol), 6, 5.95, kTol);
    const Toolpath path = clearArea(task, flatEndMill(11.9), cuttingData(3, 10), kMachine, kTol);
    EXPECT_FALSE(path.moves.empty());
    expectSound(path, task, 5.95);
}

TEST(RestArea, GoesDepthByDepthWhereShankOrHolderDip) {
    // Each corner is a block of its own; cut whole, it would be done beside three that still stand.
    const Region pocket = makeRoundedRectangle({0, 0}, {70, 50}, 4);
    ClearingTask task = restTask(pocket, blockAround(pocket, {}, kTol), 10, 4, kTol);
    const auto rises = [&] {
        const Toolpath path = clearArea(task, flatEndMill(8), cuttingData(3, 2), kMachine, kTol);
        expectSound(path, task, 4);
        int count = 0;
        double last_mm = 0;
        for (const Move& move : path.moves) {
            if (move.kind != MoveKind::Feed) continue;
            count += move.to.z() > last_mm;
            last_mm = move.to.z();
        }
        return count;
    };
    EXPECT_EQ(rises(), 3);
    task.free_reach_mm = 5;
    EXPECT_EQ(rises(), 0);
}

TEST(RestArea, HasNoLowWaysWhereTheHolderWouldTouch) {
    const Region pocket = makeRoundedRectangle({0, 0}, {70, 50}, 4);
    ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 4, kTol);
    const Vec2 left(10, 5);
    const Vec2 right(60, 5);
    EXPECT_TRUE(toolpath::Standing(task, 4, kTol).isClearForAll(left, right));
    task.kept_off.push_back({makeCircle({35, -10}, 4), 13});
    const toolpath::Standing standing(task, 4, kTol);
    EXPECT_TRUE(standing.isClear(left, right)) << "for the cutter";
    EXPECT_FALSE(standing.isClearForAll(left, right));
    EXPECT_TRUE(standing.isClearForAll({10, 25}, {60, 25}));
}

TEST(RestArea, OfALimitedTaskStaysAtItsLimits) {
    // Centres confined to a quarter of a pocket, though the tool could go everywhere.
    const Region pocket = makeRoundedRectangle({0, 0}, {60, 60}, 5);
    ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 4, kTol);
    task.centres = intersect(task.free_centres, makeRectangle({0, 0}, {30, 30}), kTol);
    task.entries.front() = {EntryKind::Helix, Vec2(20, 20), 2, Vec2::Zero()};
    const Toolpath path = clearArea(task, flatEndMill(8), cuttingData(3, 10), kMachine, kTol);
    expectSound(path, task, 4);
    for (const Path& chain : topView(path)) {
        const Box2 box = boundingBox(chain);
        EXPECT_LE(box.max().x(), 30.001);
        EXPECT_LE(box.max().y(), 30.001);
    }
}

}  // namespace
}  // namespace stepmill
