// Laws of clearing at constant engagement on random regions, tools and step-overs.

#include <gtest/gtest.h>

#include <random>

#include "stepmill/toolpath/cut_ground.h"
#include "support/random_pockets.h"
#include "support/sound_path.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using namespace test;

const Machine kQuickMachine = machineWithRapid(5000);
constexpr double kOverAngle = 0.02;
constexpr double kCusp = 0.005;
/// Of an adaptive path's cuts no more than this share of their length goes through air.
constexpr double kMostAirShare = 0.35;

class RandomBites : public testing::TestWithParam<unsigned> {
  protected:
    void SetUp() override { random_.seed(GetParam()); }

    double between(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }

    /// Where the path is adaptive: engagement bounded, ground cleared, nothing gouged, little air.
    /// \param ground  as it is when the path begins
    void expectLawful(ClearingTask task, const CutGround& ground, double r, double step_over_mm) {
        SCOPED_TRACE("seed " + std::to_string(GetParam()));
        CuttingData cutting = cuttingData(step_over_mm, 6);
        cutting.adaptive = AdaptiveData{step_over_mm, 6, 0, 0, 0};
        task.pattern = Pattern::Adaptive;
        const Toolpath path = clearArea(task, flatEndMill(2 * r), cutting, kQuickMachine, kTol);
        expectSound(path, task, r, {0.2, 0.3});
        if (path.engagement_rad <= 0) return;
        CutFollower follower(ground, r, path.step_down_mm, kCusp, CutMeasures::WidthsAndAngles);
        double cut_mm = 0;
        double air_mm = 0;
        Vec3 from = path.start;
        for (const Move& move : path.moves) {
            const MoveCut cut = follower.next(from, move);
            const double length_mm = length(Vec2(from.head<2>()), {Vec2(move.to.head<2>()), move.arc});
            from = move.to;
            if (cut.depth_mm < path.step_down_mm - 1e-6) continue;
            EXPECT_LE(cut.engaged_rad, path.engagement_rad * (1 + kOverAngle))
                << "to " << move.to.transpose();
            if (isGlide(move)) continue;
            cut_mm += length_mm;
            if (cut.widest_mm <= 0) air_mm += length_mm;
        }
        EXPECT_LE(air_mm, kMostAirShare * cut_mm);
    }

    std::mt19937 random_;
};

TEST_P(RandomBites, OfWholePockets) {
    const Region target = randomTarget(random_, kTol);
    const Region obstruction = randomObstruction(random_, target, kTol);
    const double r = between(2.5, 8);
    const ClearingTask task = fullTask(target, obstruction, r, kTol);
    expectLawful(task, CutGround(task.target, task.top_z_mm), r, 2 * r * between(0.1, 0.35));
}

TEST_P(RandomBites, OfWhatALargerToolHasLeft) {
    const Region target = randomTarget(random_, kTol);
    const Region obstruction = randomObstruction(random_, target, kTol);
    const double larger = between(4, 9);
    const double r = larger * between(0.4, 0.9);
    const ClearingTask before = fullTask(target, obstruction, larger, kTol);
    const ClearingTask task = restTask(target, obstruction, larger, r, kTol);
    CutGround ground(task.target, task.top_z_mm);
    const Toolpath cut =
        clearArea(before, flatEndMill(2 * larger), cuttingData(larger, 6), kQuickMachine, kTol);
    ground.add(cut.start, cut.moves, larger);
    expectLawful(task, ground, r, 2 * r * between(0.1, 0.35));
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomBites, testing::Range(1U, 16U));

}  // namespace
}  // namespace stepmill
