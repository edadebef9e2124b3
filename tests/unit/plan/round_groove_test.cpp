// Grooves with a round bottom, which a ball finishes.

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/plan/plan.h"
#include "support/occt_solids.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

constexpr double kLengthMm = 100;

/// A groove along x all through the top of a block, half a circle deep.
Part grooved(double radius_mm) {
    const gp_Ax2 axis(gp_Pnt(-1, 20, 20), gp::DX());
    const TopoDS_Shape groove = BRepPrimAPI_MakeCylinder(axis, radius_mm, kLengthMm + 2).Shape();
    return test::part(test::cut(test::box(0, 0, 0, kLengthMm, 40, 20), groove));
}

Plan planned(const Part& part) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.scallop_mm = 0.02;
    const ToolLibrary library =
        readToolLibrary(std::string(STEPMILL_SOURCE_DIR) + "/samples/shop_with_forms_tools.json");
    return planPart(part, request, library, defaultMachine(), kTol);
}

class RoundGroove : public testing::TestWithParam<double> {};

TEST_P(RoundGroove, IsFinishedByABallFromAbove) {
    const Plan plan = planned(grooved(GetParam()));
    ASSERT_EQ(plan.setups.size(), 1U);
    EXPECT_EQ(plan.setups.front().setup.axis, Vec3::UnitZ());
    EXPECT_TRUE(plan.setups.front().clamping.isVise());
    EXPECT_LT(plan.balance.leftMm3(), 0.05 * plan.balance.stock_minus_part_mm3);
    EXPECT_LT(plan.balance.gapShare(), 0.1 * kTol.volume_share);
}

INSTANTIATE_TEST_SUITE_P(OfSizes, RoundGroove, testing::Values(3.0, 3.5, 4.0, 6.0));

}  // namespace
}  // namespace stepmill
