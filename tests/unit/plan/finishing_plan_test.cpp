// Whole plans with a finishing allowance.

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/plan/plan.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;
constexpr FinishAllowance kAllowance{0.3, 0.2};

Plan planSample(const std::string& name, const FinishAllowance& finish, double over_top_mm = 0) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.sequence.finish = finish;
    request.setup.margin.top_mm = over_top_mm;
    const Part part = readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + name).front();
    return planPart(part, request, defaultToolLibrary(), defaultMachine(), kTol);
}

std::vector<std::string> warnedOf(const Plan& plan, const std::string& code) {
    std::vector<std::string> subjects;
    for (const Warning& warning : plan.warnings)
        if (warning.code == code) subjects.push_back(warning.subject);
    return subjects;
}

TEST(FinishingPlan, TakesTheSameToolsAndLeavesTheSame) {
    const Plan plain = planSample("rounded_pocket.step", {});
    const Plan plan = planSample("rounded_pocket.step", kAllowance);
    EXPECT_EQ(plan.totals.tool_changes, plain.totals.tool_changes);
    EXPECT_EQ(plan.totals.lower_bound_s, plain.totals.lower_bound_s);
    EXPECT_GT(plan.totals.time_s, plain.totals.time_s);
    EXPECT_GT(plan.totals.cost, plain.totals.cost);
    EXPECT_DOUBLE_EQ(plan.balance.planned_mm3, plain.balance.planned_mm3);
    EXPECT_TRUE(plan.complete(kTol));
    EXPECT_TRUE(warnedOf(plan, "no-allowance").empty());
}

TEST(FinishingPlan, OperationsTellTheirHeightsAndWhatTheyLeave) {
    const Plan plan = planSample("rounded_pocket.step", kAllowance);
    const std::vector<Operation>& operations = plan.setups.at(0).operations;
    ASSERT_EQ(operations.back().role, Role::Finish);
    EXPECT_EQ(operations.back().path.pattern, "walls");
    EXPECT_FALSE(operations.back().leaves.any());
    for (const Operation& operation : operations) {
        EXPECT_DOUBLE_EQ(operation.z_floor_mm, -12 + operation.leaves.floors_mm) << operation.id;
        const double deep_mm = operation.path.depths * operation.path.step_down_mm;
        EXPECT_NEAR(operation.z_top_mm - operation.z_floor_mm, deep_mm, 1e-9) << operation.id;
        if (operation.role != Role::Finish) {
            EXPECT_EQ(operation.leaves, kAllowance) << operation.id;
        }
    }
}

TEST(FinishingPlan, WarnsOfPlacesAsNarrowAsTheCutterAndNotOfDrilledHoles) {
    EXPECT_FALSE(warnedOf(planSample("bossed_pocket.step", kAllowance), "no-allowance").empty());
    const Plan plan = planSample("plate_with_holes.step", kAllowance);
    const std::vector<std::string> without = warnedOf(plan, "no-allowance");
    for (const Operation& operation : plan.setups.at(0).operations) {
        if (operation.role != Role::Drill) continue;
        EXPECT_EQ(std::count(without.begin(), without.end(), operation.feature_id), 0) << operation.id;
    }
}

TEST(FinishingPlan, FinishesTheFloorOfTheLowestBandAlone) {
    // So much stock over the part that it is faced in bands.
    const Plan plan = planSample("rounded_pocket.step", {0, 0.2}, 80);
    std::map<std::string, int> floors;
    for (const Operation& operation : plan.setups.at(0).operations)
        floors[operation.feature_id] += operation.role == Role::Finish ? 1 : 0;
    ASSERT_EQ(floors.count("S1.F1.2"), 1U) << "faced in bands";
    for (const auto& [feature, count] : floors) {
        const bool goes_on = floors.count("S1.F1." + std::to_string(feature.back() - '0' + 1)) > 0;
        if (feature.starts_with("S1.F1.")) {
            EXPECT_EQ(count > 0, !goes_on) << feature;
        }
    }
}

}  // namespace
}  // namespace stepmill
