// How much a cutter takes per millimetre of path, by a raster of its own.

#include <gtest/gtest.h>

#include <random>

#include "support/random_pockets.h"
#include "support/raster_simulator.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using namespace test;

using test::kMachine;
using test::kTol;
constexpr double kSlotFeed = 600;

/// Area taken over length gone is the width of cut, in the mean of a window.
constexpr double kWindowShare = 0.5;
/// What the raster and the share of the window in a narrower place leave unsure.
constexpr double kUnsureShare = 0.15;
/// Cells within this of a wall may lie on either side of the cutter's rim [mm].
constexpr double kRimMm = 0.15;

/// Widest cut at the cutting feed in the first layer, in the mean of windows of half a radius [mm].
class WidthSampler {
  public:
    WidthSampler(const ClearingTask& task, double radius_mm, double cell_mm)
        : raster_(grown(boundingBox(task.target), 2.5 * radius_mm), cell_mm),
          radius_mm_(radius_mm),
          material_(raster_.cellsOf(task.target)) {
        if (task.cleared_centres.empty()) return;
        const std::vector<double> distance = raster_.distanceTo(raster_.cellsOf(task.cleared_centres));
        for (std::size_t i = 0; i < material_.size(); ++i)
            if (distance[i] <= radius_mm + kRimMm) material_[i] = 0;
    }

    double widest(const Toolpath& path, double layer_z_mm) {
        double widest = 0;
        Vec3 from = path.start;
        for (const Move& move : path.moves) {
            const bool level = from.z() == layer_z_mm && move.to.z() == layer_z_mm;
            if (level)
                widest = std::max(widest, alongMove(from.head<2>(), move));
            else
                forget();
            from = move.to;
        }
        return widest;
    }

  private:
    double alongMove(const Vec2& from, const Move& move) {
        const Segment segment{move.to.head<2>(), move.arc};
        const double whole = length(from, segment);
        const int steps = std::max(1, static_cast<int>(std::ceil(whole / raster_.cellMm())));
        if (move.kind != MoveKind::Feed) forget();
        double widest = 0;
        for (int i = 1; i <= steps; ++i) {
            const double taken = take(pointAt(from, segment, static_cast<double>(i) / steps));
            if (move.kind != MoveKind::Feed) continue;
            area_mm2_ += taken;
            gone_mm_ += whole / steps;
            if (gone_mm_ < kWindowShare * radius_mm_) continue;
            widest = std::max(widest, area_mm2_ / gone_mm_);
            forget();
        }
        return widest;
    }

    void forget() { area_mm2_ = gone_mm_ = 0; }

    double take(const Vec2& at) {
        double cells = 0;
        raster_.forDisc(at, radius_mm_, [&](std::size_t i) {
            cells += material_[i];
            material_[i] = 0;
        });
        return cells * raster_.cellMm() * raster_.cellMm();
    }

    Raster raster_;
    double radius_mm_;
    std::vector<char> material_;
    double area_mm2_ = 0;
    double gone_mm_ = 0;
};

class RandomPocketEngagement : public testing::TestWithParam<unsigned> {};

TEST_P(RandomPocketEngagement, StaysWithinTheStepOverAtTheCuttingFeed) {
    SCOPED_TRACE("seed " + std::to_string(GetParam()));
    std::mt19937 random(GetParam());
    const Region target = randomTarget(random, kTol);
    const Region obstruction = randomObstruction(random, target, kTol);
    const double r = std::uniform_real_distribution<double>(2, 8)(random);
    const double step_over = r * std::uniform_real_distribution<double>(0.4, 1)(random);
    ClearingTask task = fullTask(target, obstruction, r, kTol);
    CuttingData cutting = cuttingData(step_over, 6);
    cutting.slot_feed_mm_per_min = kSlotFeed;
    for (const Pattern pattern : {Pattern::Best, Pattern::ContourInsideOut, Pattern::ContourOutsideIn,
                                  Pattern::StockOffset, Pattern::Zigzag, Pattern::OneWay}) {
        SCOPED_TRACE(toString(pattern));
        task.pattern = pattern;
        const Toolpath path = clearArea(task, flatEndMill(2 * r), cutting, kMachine, kTol);
        const double widest = WidthSampler(task, r, 0.1).widest(path, task.floor_z_mm);
        EXPECT_LE(widest, step_over * (1.1 + kUnsureShare) + 0.1);
    }
}

/// The sampler sees what it is there to see.
TEST(PocketEngagement, IsFullWidthSomewhereWithoutASlotFeed) {
    const Region pocket = makeRoundedRectangle({0, 0}, {60, 40}, 6);
    const ClearingTask task = fullTask(pocket, blockAround(pocket, {}, kTol), 5, kTol);
    const Toolpath path = clearArea(task, flatEndMill(10), cuttingData(4, 6), kMachine, kTol);
    EXPECT_GT(WidthSampler(task, 5, 0.1).widest(path, task.floor_z_mm), 1.5 * 4);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPocketEngagement, testing::Range(1U, 31U));

}  // namespace
}  // namespace stepmill
