// The pocket that other systems' figures are known for: 70 x 50 x 12, corners of 6, an island of 16.

#include <gtest/gtest.h>

#include "support/clearing_tasks.h"
#include "support/raster_simulator.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using namespace test;

using test::kMachine;
using test::kTol;

struct Rival {
    double diameter_mm;
    double time_s;  ///< FreeCAD 0.20's Pocket at these cutting data; plunges straight
};

/// Shorter than elsewhere by this share at a ramp angle of 3 degrees. The largest cutter has two places to
/// itself, each one ring of 95.6 mm: three times round both and one ramp of 76 mm in each take 43.6 s, so
/// 0.07 is out of reach.
constexpr double kShorter = 0.1;
constexpr double kLargestShorter = 0.025;

class CommonPocket : public testing::TestWithParam<Rival> {
  protected:
    ClearingTask task() const {
        Region pocket = makeRoundedRectangle({0, 0}, {70, 50}, 6);
        pocket.loops.push_back(reversed(makeCircle({35, 25}, 8).loops.front()));
        ClearingTask result =
            fullTask(pocket, blockAround(pocket, {}, kTol), GetParam().diameter_mm / 2, kTol);
        result.floor_z_mm = -12;
        return result;
    }
    Toolpath path() const {
        const double d = GetParam().diameter_mm;
        return clearArea(task(), flatEndMill(d), cuttingData(d / 2, 4), kMachine, kTol);
    }
};

TEST_P(CommonPocket, IsShorterThanElsewhereWithARampedEntry) {
    const Toolpath made = path();
    RecordProperty("time_s", std::to_string(made.totals.time_s()));
    const double shorter = GetParam().diameter_mm < 20 ? kShorter : kLargestShorter;
    EXPECT_LE(made.totals.time_s(), (1 - shorter) * GetParam().time_s);
    for (const Move& move : made.moves)
        EXPECT_TRUE(move.kind != MoveKind::Plunge || move.in_air);
}

TEST_P(CommonPocket, IsClearedWithoutAGouge) {
    const double r = GetParam().diameter_mm / 2;
    const Toolpath made = path();
    const SimulatedCut cut = simulate(made, task(), r, 0.1, 0.15);
    EXPECT_EQ(cut.gouged_mm2, 0);
    EXPECT_EQ(cut.left_mm2, 0);
    EXPECT_EQ(cut.bad_rapids, 0);
    const PathProof proof = prove(made, task(), r, kTol);
    EXPECT_GE(proof.least_clearance_mm, 0);
    EXPECT_TRUE(proof.rapids_clear);
}

TEST_P(CommonPocket, FeedsHardlyAnywhereInAir) {
    const PathTotals totals = path().totals;
    EXPECT_LT(totals.feed_air_length_mm, 0.05 * totals.cut_length_mm);
}

INSTANTIATE_TEST_SUITE_P(Cutters, CommonPocket,
                         testing::Values(Rival{20, 46.8}, Rival{12, 103.0}, Rival{6, 257.3}));

}  // namespace
}  // namespace stepmill
