// The part of [DSouza2006], Fig. 8, whose geometry is not printed: our pocket with and without bosses, after
// its Tables 3 and 4, with the tools and holders of its Tables 1 and 2.

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/plan/plan.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

/// The pocket with its sequence: the last feature of the part.
PlannedFeature planPocket(const std::string& name, SurrogateRule rule) {
    const std::string source = STEPMILL_SOURCE_DIR;
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.sequence.surrogates = rule;
    const Part part = readStep(source + "/step_parts/" + name + ".step").front();
    const ToolLibrary library = readToolLibrary(source + "/samples/dsouza2006_tools.json");
    // The paper's rapids touch.
    Machine machine = defaultMachine();
    machine.side_clearance_mm = machine.top_clearance_mm = machine.inside_clearance_mm = 0;
    const Plan plan = planPart(part, request, library, machine, kTol);
    EXPECT_TRUE(plan.complete(kTol)) << name;
    return plan.setups.front().features.back();
}

using Steps = std::vector<std::pair<std::string, Role>>;

Steps stepsOf(const PlannedFeature& pocket) {
    Steps steps;
    for (const SequenceStep& step : pocket.sequence.steps)
        steps.emplace_back(step.tool_id, step.role);
    return steps;
}

class PaperCase : public testing::TestWithParam<SurrogateRule> {};

// Table 3: 0.5, 0.2, 0.125 in, with the 0.2 in cutter as the surrogate of the first.
TEST_P(PaperCase, WithBossesTheNextToolIsTheSurrogateOfTheFirst) {
    const Steps expected = {{"t8", Role::Rough},
                            {"t2", Role::Surrogate},
                            {"t2", Role::Surrogate},
                            {"t2", Role::Rest},
                            {"t1", Role::Rest}};
    EXPECT_EQ(stepsOf(planPocket("bossed_pocket", GetParam())), expected);
}

// Table 4 has other tools, too, in other places: 0.375, 0.2, 0.125 in. Here it is 0.5, 0.3125, 0.125 in.
TEST_P(PaperCase, WithoutBossesTheToolsAreOthersAndTheTimeIsLess) {
    const PlannedFeature with = planPocket("bossed_pocket", GetParam());
    const PlannedFeature without = planPocket("pocket_without_bosses", GetParam());
    EXPECT_EQ(stepsOf(without), (Steps{{"t8", Role::Rough}, {"t4", Role::Rest}, {"t1", Role::Rest}}));
    EXPECT_LT(without.sequence.time_s, with.sequence.time_s);
    EXPECT_NEAR(with.feature.area_mm2, without.feature.area_mm2, 1e-6 * with.feature.area_mm2);
}

INSTANTIATE_TEST_SUITE_P(BothRules, PaperCase,
                         testing::Values(SurrogateRule::Single, SurrogateRule::Sequence));

}  // namespace
}  // namespace stepmill
