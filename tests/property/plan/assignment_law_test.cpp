#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/plan/plan.h"
#include "stepmill/planar/boolean.h"
#include "support/dice.h"
#include "support/occt_solids.h"
#include "support/tolerances.h"

// Which setup cuts what, against all splits of the waste around a part on a grid of depths.

namespace stepmill {
namespace {

using test::kTol;
/// What a split on the grid may be better by.
constexpr double kMostBetter = 1.01;
constexpr int kSplits = 3;

/// A block with a pocket above and one below, in a blank that is wider all round.
struct TwoSided {
    Part part;
    PlanRequest request;
    double high_mm = 0;
};

TwoSided twoSided(test::Dice& dice) {
    const double x = dice.between(50, 120, 1);
    const double y = dice.between(40, 80, 1);
    const double z = dice.between(25, 70, 1);
    const TopoDS_Shape above = test::box(10, 10, z - 6, x - 20, y - 20, 10);
    const TopoDS_Shape below = test::box(12, 12, -2, x - 24, y - 24, dice.between(5, 8, 1));
    TwoSided made;
    made.part = test::part(test::cut(test::cut(test::box(0, 0, 0, x, y, z), above), below));
    made.high_mm = z;
    made.request.sequence.material = "aluminium";
    made.request.setup.axes = {Vec3::UnitZ(), -Vec3::UnitZ()};
    made.request.setup.margin.side_mm = dice.between(3, 15, 1);
    return made;
}

Plan planned(const TwoSided& two) {
    return planPart(two.part, two.request, defaultToolLibrary(), defaultMachine(), kTol);
}

/// The plan in which the first setup leaves the waste around the part below that depth to the second.
Plan splitAt(TwoSided two, double depth_mm) {
    const Setup first = chooseSetups(two.part, two.request.setup).front();
    const Box3 size = first.stock_bbox_mm;
    const Vec2 margin = Vec2::Constant(two.request.setup.margin.side_mm);
    const Region ring =
        subtract(makeRectangle(size.min().head<2>(), size.max().head<2>()),
                 makeRectangle(size.min().head<2>() + margin, size.max().head<2>() - margin), kTol);
    two.request.assignment = Assignment{};
    if (depth_mm < two.high_mm)
        two.request.assignment->reserves = {{first.part_to_setup, {{ring, -depth_mm, -two.high_mm}}}};
    return planned(two);
}

double staysMm3(const Plan& plan) {
    return plan.balance.residual_mm3 + plan.balance.unreachable_mm3;
}

TEST(AssignmentLaw, NoSplitOnAGridIsBetter) {
    for (const std::uint64_t seed : {1, 2}) {
        test::Dice dice(seed);
        const TwoSided two = twoSided(dice);
        const Plan chosen = planned(two);
        EXPECT_LE(chosen.balance.gapShare(), kTol.volume_share) << "seed " << seed;
        for (int i = 0; i <= kSplits; ++i) {
            const Plan split = splitAt(two, two.high_mm * i / kSplits);
            if (staysMm3(split) > staysMm3(chosen) + kVolumeRoundingMm3) continue;
            EXPECT_LE(chosen.totals.motion_s, kMostBetter * split.totals.motion_s)
                << "seed " << seed << " split at " << two.high_mm * i / kSplits;
        }
    }
}

TEST(AssignmentLaw, IsNoWorseThanCuttingAllThatIsReached) {
    for (const std::uint64_t seed : {4}) {
        test::Dice dice(seed);
        TwoSided two = twoSided(dice);
        const Plan chosen = planned(two);
        two.request.assign = false;
        const Plan greedy = planned(two);
        EXPECT_LE(chosen.totals.motion_s, greedy.totals.motion_s) << "seed " << seed;
        EXPECT_LE(staysMm3(chosen), staysMm3(greedy) + kVolumeRoundingMm3) << "seed " << seed;
        EXPECT_TRUE(greedy.assignment.tried.empty());
    }
}

}  // namespace
}  // namespace stepmill
