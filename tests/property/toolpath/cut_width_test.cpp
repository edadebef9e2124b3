// Widths of cuts against a raster that the same moves clear.

#include <gtest/gtest.h>

#include <random>

#include "stepmill/toolpath/cut_ground.h"
#include "support/random_pockets.h"
#include "support/raster_simulator.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using namespace test;

using test::kMachine;
using test::kTol;
constexpr double kCellMm = 0.1;
/// Areas are compared over stretches of this many radii.
constexpr double kStretchShare = 0.6;
/// What cells leave unsure of a width [mm].
constexpr double kUnsureMm = 0.35;

/// Clears cells along level moves and tells the area of each stretch.
class AreaMeter {
  public:
    AreaMeter(const ClearingTask& task, double radius_mm)
        : raster_(grown(boundingBox(task.target), 2.5 * radius_mm), kCellMm),
          radius_mm_(radius_mm),
          material_(raster_.cellsOf(task.target)) {}

    /// Area of the cells that the disc takes on its way over a part of the edge.
    double taken(const Edge& edge, double from_share, double to_share) {
        const double whole_mm = length(edge) * (to_share - from_share);
        const int steps = std::max(1, static_cast<int>(std::ceil(whole_mm / kCellMm)));
        double cells = 0;
        for (int i = 0; i <= steps; ++i)
            cells += take(pointAt(edge, from_share + (to_share - from_share) * i / steps));
        return cells * kCellMm * kCellMm;
    }

  private:
    double take(const Vec2& at) {
        double cells = 0;
        raster_.forDisc(at, radius_mm_, [&](std::size_t i) {
            cells += material_[i];
            material_[i] = 0;
        });
        return cells;
    }

    Raster raster_;
    double radius_mm_;
    std::vector<char> material_;
};

class RandomPocketWidths : public testing::TestWithParam<unsigned> {};

/// Over a line the area taken is the mean width times the length; the greatest width is no less.
TEST_P(RandomPocketWidths, AreThoseOfARaster) {
    SCOPED_TRACE("seed " + std::to_string(GetParam()));
    std::mt19937 random(GetParam());
    const Region target = randomTarget(random, kTol);
    const Region obstruction = randomObstruction(random, target, kTol);
    const double r = std::uniform_real_distribution<double>(3, 8)(random);
    const double step_over = r * std::uniform_real_distribution<double>(0.4, 1)(random);
    const ClearingTask task = fullTask(target, obstruction, r, kTol);
    const Toolpath path = clearArea(task, flatEndMill(2 * r), cuttingData(step_over, 6), kMachine, kTol);
    const CutGround ground(task.target, task.top_z_mm);
    CutFollower follower(ground, r, path.step_down_mm, 0.005);
    AreaMeter meter(task, r);
    double sum_mm2 = 0;
    double meter_mm2 = 0;
    Vec3 from = path.start;
    for (const Move& move : path.moves) {
        const MoveCut cut = follower.next(from, move);
        const Edge edge = edgeOf(from, move);
        const bool down = move.kind != MoveKind::Rapid && move.to.z() == task.floor_z_mm;
        const double slope_mm = std::abs(from.z() - move.to.z());
        from = move.to;
        if (!down) continue;
        const double whole_mm = length(edge);
        if (cut.widths_mm == nullptr || slope_mm > 0 || move.arc || whole_mm < 2 * r) {
            meter.taken(edge, 0, 1);
            continue;
        }
        const std::vector<double>& widths = *cut.widths_mm;
        const std::size_t steps = widths.size() - 1;
        const auto stride = static_cast<std::size_t>(std::lround(kStretchShare / kCutStepShare));
        const auto place = [&](std::size_t index) {
            return std::min(1.0, static_cast<double>(index) * kCutStepShare * r / whole_mm);
        };
        meter.taken(edge, 0, 0);
        for (std::size_t i = 0; i < steps; i += stride) {
            const std::size_t end = std::min(steps, i + stride);
            const double a = place(i);
            const double b = place(end);
            const double taken_mm2 = meter.taken(edge, a, b);
            const double widest = *std::max_element(widths.begin() + static_cast<std::ptrdiff_t>(i),
                                                    widths.begin() + static_cast<std::ptrdiff_t>(end) + 1);
            EXPECT_LE(taken_mm2 / ((b - a) * whole_mm),
                      widest + kUnsureMm + kUnsureMm * r / ((b - a) * whole_mm))
                << "at " << pointAt(edge, a).transpose();
            for (std::size_t k = i; k < end; ++k)
                sum_mm2 += (widths[k] + widths[k + 1]) / 2 * (place(k + 1) - place(k)) * whole_mm;
            meter_mm2 += taken_mm2;
        }
    }
    EXPECT_NEAR(sum_mm2, meter_mm2, 0.05 * meter_mm2 + 5);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomPocketWidths, testing::Range(1U, 11U));

}  // namespace
}  // namespace stepmill
