// Laws of clearing on random regions and tools, checked by raster.

#include <gtest/gtest.h>

#include <random>

#include "support/random_pockets.h"
#include "support/sound_path.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using namespace test;

using test::kMachine;
using test::kTol;

/// The path of the task, sound and without moves that go nowhere.
Toolpath soundPath(const ClearingTask& task, double radius_mm, double step_over_mm) {
    const Toolpath path =
        clearArea(task, flatEndMill(2 * radius_mm), cuttingData(step_over_mm, 4), kMachine, kTol);
    expectSound(path, task, radius_mm, {0.2, 0.3});
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        EXPECT_TRUE(move.arc.has_value() || move.to != from) << "a move without length";
        from = move.to;
    }
    return path;
}

/// Every pattern asked for on its own, then all weighed: that must be as quick as the quickest in a task of
/// one region, and in any task as quick as the sum of the regions' quickest.
void expectEveryPatternSound(ClearingTask task, double radius_mm, double step_over_mm) {
    double quickest_s = std::numeric_limits<double>::infinity();
    for (const Pattern pattern : {Pattern::ContourInsideOut, Pattern::ContourOutsideIn, Pattern::StockOffset,
                                  Pattern::Zigzag, Pattern::OneWay}) {
        SCOPED_TRACE(toString(pattern));
        task.pattern = pattern;
        quickest_s = std::min(quickest_s, soundPath(task, radius_mm, step_over_mm).totals.time_s());
    }
    task.pattern = Pattern::Best;
    const Toolpath best = soundPath(task, radius_mm, step_over_mm);
    // Ways between regions are no part of the choice.
    if (best.regions.size() <= 1) {
        EXPECT_LE(best.totals.time_s(), quickest_s * (1 + 1e-5));
    }
    for (const RegionPatterns& region : best.regions)
        for (const PatternTime& other : region.weighed)
            EXPECT_LE(region.weighed.front().time_s, other.time_s * (1 + 1e-5));
}

class RandomPockets : public testing::TestWithParam<unsigned> {};

TEST_P(RandomPockets, AreClearedWithoutAGouge) {
    SCOPED_TRACE("seed " + std::to_string(GetParam()));
    std::mt19937 random(GetParam());
    const Region target = randomTarget(random, kTol);
    const Region obstruction = randomObstruction(random, target, kTol);
    const double r = std::uniform_real_distribution<double>(1.5, 8)(random);
    const double step_over = r * std::uniform_real_distribution<double>(0.3, 1)(random);
    expectEveryPatternSound(fullTask(target, obstruction, r, kTol), r, step_over);
}

TEST_P(RandomPockets, AreFinishedByASmallerTool) {
    SCOPED_TRACE("seed " + std::to_string(GetParam()));
    std::mt19937 random(1000 + GetParam());
    const Region target = randomTarget(random, kTol);
    const Region obstruction = randomObstruction(random, target, kTol);
    const double larger = std::uniform_real_distribution<double>(4, 9)(random);
    const double r = larger * std::uniform_real_distribution<double>(0.3, 0.9)(random);
    expectEveryPatternSound(restTask(target, obstruction, larger, r, kTol), r, 0.8 * r);
}

TEST_P(RandomPockets, AreClearedWithRapidsOverTheirWindows) {
    SCOPED_TRACE("seed " + std::to_string(GetParam()));
    std::mt19937 random(2000 + GetParam());
    const Region pocket = randomTarget(random, kTol);
    const auto widest = ClearanceDiagram(pocket, kTol).largestInscribedDisc();
    ASSERT_TRUE(widest);
    const Region window = makeCircle(snapToGrid(widest->centre), 0.9 * widest->radius_mm);
    const Region target = subtract(pocket, window, kTol);
    const double r = widest->radius_mm * std::uniform_real_distribution<double>(0.1, 0.3)(random);
    ClearingTask task = fullTask(target, randomObstruction(random, pocket, kTol), r, kTol);
    // Lines to and fro cross what rings go round.
    task.pattern = Pattern::Zigzag;
    const Toolpath fed = soundPath(task, r, r);
    const Toolpath path = withRapidsOverVoids(fed, task, r, kMachine, kTol);
    expectSound(path, task, r, {0.2, 0.3});
    EXPECT_LE(path.totals.motion_time_s, fed.totals.motion_time_s);
    EXPECT_TRUE(prove(path, task, r, kTol).rapids_clear);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPockets, testing::Range(1U, 61U));

/// Regions whose offsets once came out wrong: near-tangent arcs, crescents, closed necks.
INSTANTIATE_TEST_SUITE_P(HardOffsets, RandomPockets, testing::Values(115U, 165U, 179U, 269U));

}  // namespace
}  // namespace stepmill
