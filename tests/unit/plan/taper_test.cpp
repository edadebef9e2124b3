// Tapers that run out into a bore.

#include <algorithm>

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/plan/plan.h"
#include "support/occt_solids.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

TEST(Taper, IsFinishedDownToTheBoreWhateverLayersTakeIt) {
    // The lower half of the cone lies in one flat layer with the bore, which is cut in two bands.
    const gp_Ax2 foot(gp_Pnt(20, 20, 45), gp::DZ());
    const TopoDS_Shape cone = BRepPrimAPI_MakeCone(foot, 8, 12, 15).Shape();
    const TopoDS_Shape bored = test::cut(test::box(0, 0, 0, 40, 40, 60), test::cylinder(20, 20, 0, 8, 60));
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.scallop_mm = 0.02;
    const ToolLibrary library =
        readToolLibrary(std::string(STEPMILL_SOURCE_DIR) + "/samples/shop_with_forms_tools.json");
    const Plan plan = planPart(test::part(test::cut(bored, cone)), request, library, defaultMachine(), kTol);
    ASSERT_EQ(plan.setups.size(), 1U);
    const auto form =
        std::find_if(plan.setups.front().operations.begin(), plan.setups.front().operations.end(),
                     [](const Operation& operation) { return operation.role == Role::Form; });
    ASSERT_NE(form, plan.setups.front().operations.end());
    EXPECT_LT(form->z_floor_mm, -14.5);
    // Flat cutters leave some 400 mm3 over the cone.
    EXPECT_LT(plan.balance.leftMm3(), 60);
    EXPECT_LT(plan.balance.gapShare(), 0.1 * kTol.volume_share);
}

}  // namespace
}  // namespace stepmill
