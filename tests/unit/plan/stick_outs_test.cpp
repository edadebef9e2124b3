#include <gtest/gtest.h>

#include "plan/operations/stick_outs.h"
#include "plan/plan_warnings.h"
#include "stepmill/catalog/read_catalog.h"
#include "support/told.h"
#include "support/tolerances.h"
#include "support/tool_makers.h"

namespace stepmill {
namespace {

using test::kTol;

ToolAssembly ranged(const std::string& id) {
    ToolAssembly tool = test::inHolder(test::bareTool(id, ToolType::Flat, 10), 30, 40, 30);
    tool.stick_out_range = StickOutRange{10, 30};
    return tool;
}

SequenceStep step(const std::string& tool_id, double least_stick_out_mm) {
    SequenceStep result;
    result.tool_id = tool_id;
    result.least_stick_out_mm = least_stick_out_mm;
    return result;
}

TEST(StickOuts, AToolIsSetAsFarOutAsItsNeediestStepAsks) {
    ToolLibrary library;
    library.tools = {ranged("A"), ranged("B")};
    std::vector<PlannedSetup> setups(2);
    setups[0].features.resize(1);
    setups[0].features[0].sequence.steps = {step("A", 14), step("A", 12)};
    setups[1].features.resize(1);
    setups[1].features[0].sequence.steps = {step("A", 18)};
    library = withStickOuts(library, setups);
    EXPECT_DOUBLE_EQ(library.tool("A").stick_out_mm, 18);
    EXPECT_DOUBLE_EQ(library.tool("A").holder[0].bottom_mm, 18);
    EXPECT_DOUBLE_EQ(library.tool("B").stick_out_mm, 30) << "no step asks for it";
}

/// A plan with tools set as it says takes no longer.
TEST(StickOuts, AreLongEnoughForThePlanTheyWereChosenFor) {
    const Part part = readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/nested_pockets.step").front();
    PlanRequest request;
    request.sequence.material = "aluminium";
    ToolLibrary library = defaultToolLibrary();
    for (ToolAssembly& tool : library.tools)
        tool.stick_out_range = StickOutRange{tool.shank.bottom_mm, tool.stick_out_mm};
    const Plan plan = planPart(part, request, library, defaultMachine(), kTol);
    int shorter = 0;
    for (std::size_t i = 0; i < library.tools.size(); ++i) {
        const ToolAssembly& set = plan.library.tools[i];
        EXPECT_GE(set.stick_out_mm, set.stick_out_range->shortest_mm);
        EXPECT_LE(set.stick_out_mm, library.tools[i].stick_out_mm);
        shorter += set.stick_out_mm < library.tools[i].stick_out_mm ? 1 : 0;
    }
    EXPECT_GT(shorter, 0);
    ToolLibrary fixed = plan.library;
    for (ToolAssembly& tool : fixed.tools)
        tool.stick_out_range.reset();
    const Plan again = planPart(part, request, fixed, defaultMachine(), kTol);
    EXPECT_NEAR(again.totals.time_s, plan.totals.time_s, 1e-6 * plan.totals.time_s);
    EXPECT_NEAR(again.balance.residual_mm3, plan.balance.residual_mm3, 1e-3);
}

/// One feature of 1000 mm2, 10 mm deep: a large tool does most, a small one `area_mm2` in `time_s`.
PlannedSetup setupWithSmallTool(double area_mm2, double time_s, Role role) {
    PlannedSetup setup;
    PlannedFeature planned;
    planned.feature.id = "S1.F1";
    planned.feature.top_z_mm = 0;
    planned.feature.floor_z_mm = planned.sequence.floor_z_mm = -10;
    planned.feature.area_mm2 = 1000;
    planned.feature.volume_mm3 = 10000;
    planned.sequence.steps = {step("large", 0), step("small", 0)};
    planned.sequence.steps[0].area.new_area_mm2 = 1000 - area_mm2;
    planned.sequence.steps[1].area.new_area_mm2 = area_mm2;
    planned.sequence.steps[1].role = role;
    setup.features.push_back(planned);
    for (const auto& [tool, seconds] : {std::pair("large", 500.0), std::pair("small", time_s)}) {
        Operation operation;
        operation.feature_id = "S1.F1";
        operation.tool_id = tool;
        operation.path.totals.feed_time_s = seconds;
        setup.operations.push_back(operation);
    }
    return setup;
}

TEST(SlowSteps, AreNamedWithWhatTheyBuy) {
    const std::vector<Warning> warnings = slowSteps(setupWithSmallTool(10, 1500, Role::Surrogate));
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_EQ(warnings[0].code, "slow");
    EXPECT_EQ(warnings[0].subject, "S1.F1");
    EXPECT_TRUE(
        test::tells(warnings[0].text, {"small", "25 min", "33 min", "0.10", "10.00 cm3", "slimmer holder"}));
}

TEST(SlowSteps, AreNotNamedWhereTheyClearMuchOrTakeLittle) {
    EXPECT_TRUE(slowSteps(setupWithSmallTool(100, 1500, Role::Rest)).empty());
    EXPECT_TRUE(slowSteps(setupWithSmallTool(10, 200, Role::Rest)).empty());
}

}  // namespace
}  // namespace stepmill
