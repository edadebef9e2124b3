// Whole plans of roughing alone.

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/proven/proven_plan.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;
constexpr FinishAllowance kHalf{0.5, 0.5};

class RoughedSample : public testing::TestWithParam<const char*> {};

TEST_P(RoughedSample, IsProvenAndLeavesTheAllowance) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.roughing = kHalf;
    const Part part =
        readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + GetParam() + ".step").front();
    const ProvenPlan proven = planProven(part, request, defaultToolLibrary(), defaultMachine(), kTol);
    EXPECT_TRUE(proven.mayRun());
    EXPECT_TRUE(proven.plan.complete(kTol));
    EXPECT_GT(proven.plan.balance.planned_mm3, 0);
    const bool named = std::any_of(
        proven.plan.balance.residual_by_reason.begin(), proven.plan.balance.residual_by_reason.end(),
        [](const ReasonVolume& entry) { return entry.reason == Reason::Allowance && entry.volume_mm3 > 0; });
    EXPECT_TRUE(named);
}

INSTANTIATE_TEST_SUITE_P(Parts, RoughedSample,
                         testing::Values("die_cavity", "mold_core", "nested_pockets", "open_slots",
                                         "plate_with_holes"));

}  // namespace
}  // namespace stepmill
