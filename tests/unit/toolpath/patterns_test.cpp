// Which pattern a region gets, and what the patterns look like.

#include <gtest/gtest.h>

#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"
#include "support/clearing_tasks.h"
#include "support/raster_simulator.h"
#include "support/tolerances.h"
#include "toolpath/script/region_cut.h"

namespace stepmill {
namespace {

using namespace test;

using test::kMachine;
using test::kTol;

Toolpath cutWith(ClearingTask task, Pattern pattern, double radius_mm, double step_over_mm) {
    task.pattern = pattern;
    return clearArea(task, flatEndMill(2 * radius_mm), cuttingData(step_over_mm, 10), kMachine, kTol);
}

/// Level feeds longer than that, as directions in [0, 180) degrees.
std::vector<double> anglesOfLongFeeds(const Toolpath& path, double longer_than_mm) {
    std::vector<double> angles;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const Vec2 along = (move.to - from).head<2>();
        if (move.kind == MoveKind::Feed && !move.arc && along.norm() > longer_than_mm) {
            const double angle = std::atan2(along.y(), along.x()) * 180 / kPi;
            angles.push_back(angle < -1e-6 ? angle + 180 : angle > 180 - 1e-6 ? angle - 180 : angle);
        }
        from = move.to;
    }
    return angles;
}

TEST(Patterns, RunLinesAlongANarrowPocket) {
    // 120 x 30, turned by 30 degrees.
    const Eigen::Rotation2Dd turn(degToRad(30));
    std::vector<Vec2> corners;
    for (const Vec2& corner : {Vec2(0, 0), Vec2(120, 0), Vec2(120, 30), Vec2(0, 30)})
        corners.push_back(turn * corner);
    const Region pocket = makePolygon(corners);
    const ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 10, kTol);
    const Toolpath path = cutWith(task, Pattern::Zigzag, 10, 4);
    ASSERT_EQ(path.regions.size(), 1U);
    EXPECT_EQ(path.pattern, "zigzag at 30 deg");
    const std::vector<double> angles = anglesOfLongFeeds(path, 60);
    EXPECT_GE(angles.size(), 4U);  // two rows in the 10 mm of the centres, and two walls
    for (const double angle : angles)
        EXPECT_NEAR(angle, 30, 1e-3);
}

TEST(Patterns, OfAClosedPocketAreRings) {
    const Region pocket = makeRoundedRectangle({0, 0}, {70, 50}, 6);
    const Toolpath path =
        cutWith(fullTask(pocket, blockAround(pocket, {}, kTol), 5, kTol), Pattern::Best, 5, 5);
    EXPECT_EQ(path.pattern.substr(0, 16), "contour-parallel");
}

TEST(Patterns, WeighedAreFiveWhereThereIsAnIslandAndFourWhereThereIsNone) {
    Region pocket = makeRoundedRectangle({0, 0}, {70, 50}, 6);
    const Toolpath without =
        cutWith(fullTask(pocket, blockAround(pocket, {}, kTol), 4, kTol), Pattern::Best, 4, 4);
    ASSERT_EQ(without.regions.size(), 1U);
    EXPECT_EQ(without.regions.front().weighed.size(), 4U);
    pocket.loops.push_back(reversed(makeCircle({35, 25}, 8).loops.front()));
    const Toolpath with =
        cutWith(fullTask(pocket, blockAround(pocket, {}, kTol), 4, kTol), Pattern::Best, 4, 4);
    ASSERT_EQ(with.regions.size(), 1U);
    EXPECT_EQ(with.regions.front().weighed.size(), 5U);
}

TEST(Patterns, OneWayRunsEveryLineInClimbDirection) {
    // A step along a wall at y = 0: the uncut side must be on the right of every line.
    const Region face = makeRectangle({0, 0}, {80, 30});
    const Toolpath path = cutWith(fullTask(face, {}, 5, kTol), Pattern::OneWay, 5, 4);
    EXPECT_EQ(path.pattern, "one-way at 0 deg");
    double last_y = -1e9;
    int lines = 0;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        if (move.kind == MoveKind::Feed && std::abs(move.to.x() - from.x()) > 60) {
            EXPECT_LT(move.to.x(), from.x());
            EXPECT_GT(move.to.y(), last_y);
            last_y = move.to.y();
            ++lines;
        }
        from = move.to;
    }
    EXPECT_EQ(lines, 8);  // 40 mm across the centres in ten gaps; the ninth would cut nothing
}

TEST(Patterns, StockOffsetFollowsTheOuterWallUntilItMeetsAnIsland) {
    Region pocket = makeRectangle({0, 0}, {100, 100});
    pocket.loops.push_back(reversed(makeCircle({50, 50}, 20).loops.front()));
    const ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 5, kTol);
    const Toolpath path = cutWith(task, Pattern::StockOffset, 5, 4);
    EXPECT_EQ(path.pattern, "stock-offset");
    // Centres of 90 x 90: squares of 90, 82, 74, 66 and 58 pass before the island's circle of 50 is met.
    double squares = 0;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const bool straight = move.kind == MoveKind::Feed && !move.arc && move.to.z() == task.floor_z_mm;
        const Vec2 along = (move.to - from).head<2>();
        if (straight && along.norm() > 50) squares += 1;
        from = move.to;
    }
    // Four sides each; where a square begins in the middle of a side, that is in two halves.
    EXPECT_GE(squares, 5 * 3);
    EXPECT_LE(squares, 5 * 4);
    const SimulatedCut cut = simulate(path, task, 5, 0.1, 0.15);
    EXPECT_EQ(cut.gouged_mm2, 0);
    EXPECT_EQ(cut.left_mm2, 0);
}

TEST(Patterns, ARestNoWiderThanTheStepOverIsASinglePassAlongTheWall) {
    // What 20 mm leave in corners of 3: less than 3 mm off the wall of a 6 mm cutter's centre.
    const Region pocket = makeRoundedRectangle({0, 0}, {70, 50}, 5);
    const ClearingTask task = restTask(pocket, blockAround(pocket, {}, kTol), 10, 3, kTol);
    const Toolpath path = cutWith(task, Pattern::Best, 3, 3);
    for (const Path& chain : topView(path)) {
        Path pass = chain;
        pass.segments.pop_back();  // off the wall
        for (const auto& [from, segment] : eachEdge(pass))
            EXPECT_NEAR(distanceToBoundary(pocket, pointAt(from, segment, 0.5)), 3, 0.01);
    }
    EXPECT_EQ(topView(path).size(), 4U);
}

TEST(Patterns, OfRegionsApartAreChosenOneByOne) {
    const Region pockets = unite(makeRoundedRectangle({0, 0}, {30, 40}, 6), makeCircle({80, 20}, 15), kTol);
    const ClearingTask task = fullTask(pockets, blockAround(pockets, {}, kTol), 5, kTol);
    const Toolpath path = cutWith(task, Pattern::Best, 5, 4);
    ASSERT_EQ(path.regions.size(), 2U);
    for (const RegionPatterns& region : path.regions)
        for (const PatternTime& other : region.weighed)
            EXPECT_LE(region.weighed.front().time_s, other.time_s * (1 + 1e-5));
}

TEST(SlotFeed, SlowsFullWidthCutsAndRampsAlone) {
    const Region pocket = makeRoundedRectangle({0, 0}, {60, 40}, 6);
    const ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 5, kTol);
    CuttingData cutting = cuttingData(4, 10);
    const Toolpath plain = clearArea(task, flatEndMill(10), cutting, kMachine, kTol);
    EXPECT_EQ(plain.slot_feed_mm_per_min, 0);
    cutting.slot_feed_mm_per_min = 600;
    const Toolpath slowed = clearArea(task, flatEndMill(10), cutting, kMachine, kTol);
    EXPECT_EQ(slowed.feedOf(MoveKind::Slot), 600);
    EXPECT_EQ(slowed.ramp_feed_mm_per_min, 600);
    EXPECT_GT(slowed.totals.time_s(), plain.totals.time_s());
    int slots = 0;
    int feeds = 0;
    for (const Move& move : slowed.moves) {
        slots += move.kind == MoveKind::Slot ? 1 : 0;
        feeds += move.kind == MoveKind::Feed ? 1 : 0;
    }
    EXPECT_GT(slots, 0);
    EXPECT_GT(feeds, 0);
}

/// Minutes of a cutting layer as [Li2001, Table 1] prints them.
struct PrintedLayer {
    double stock_offset = 0;
    double parallel = 0;
    double best = 0;
};
constexpr PrintedLayer kPrintedLayers[] = {
    {17.68, 15.99, 15.99}, {17.79, 16.33, 16.33}, {18.59, 17.38, 17.38}, {18.56, 17.30, 17.30},
    {18.08, 17.21, 17.21}, {18.15, 17.33, 17.33}, {18.29, 16.74, 16.74}, {18.34, 17.33, 17.33},
    {17.46, 17.29, 17.29}, {16.99, 16.89, 16.89}, {15.77, 16.62, 15.77}, {14.23, 14.51, 14.23},
    {12.68, 13.92, 12.68}, {11.83, 13.33, 11.83}};
/// Sum of its column "Best pattern", and the loss of the pattern that its rules select [%].
constexpr double kPrintedBest = 224.31;
constexpr double kPrintedLossPercent = 0.50;
/// The sum was printed by rows with more digits.
constexpr double kPrintedRounding = 14 * 0.005;

TEST(Patterns, OfThePapersLayersTheBestIsTakenInEach) {
    double sum = 0;
    for (const PrintedLayer& layer : kPrintedLayers) {
        PatternTime taken{Pattern::StockOffset, 0, 60 * layer.stock_offset};
        const PatternTime parallel{Pattern::Zigzag, 0, 60 * layer.parallel};
        if (toolpath::isQuicker(parallel, taken)) taken = parallel;
        EXPECT_DOUBLE_EQ(taken.time_s, 60 * layer.best);
        sum += taken.time_s / 60;
    }
    EXPECT_NEAR(sum, kPrintedBest, kPrintedRounding);
    // The paper's rules choose before they cut, and lose half a percent.
    EXPECT_LT(sum, kPrintedBest * (1 + kPrintedLossPercent / 100));
}

}  // namespace
}  // namespace stepmill
