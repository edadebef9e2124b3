// The part of [DSouza2006], Fig. 8, whose geometry is not printed: our pocket with and without bosses, after
// its Tables 3 and 4, with the tools and holders of its Tables 1 and 2.

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/plan/plan.h"
#include "support/sample_feature.h"
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
    // The paper's rapids and holders touch.
    Machine machine = defaultMachine();
    machine.side_clearance_mm = machine.top_clearance_mm = machine.inside_clearance_mm = 0;
    machine.holder_clearance_mm = 0;
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

class PaperCaseByRule : public testing::TestWithParam<SurrogateRule> {};

// Table 3: 0.5, 0.2, 0.125 in, with the 0.2 in cutter as the surrogate of the first.
TEST(PaperCase, WithBossesTheNextToolIsTheSurrogateOfTheFirst) {
    const Steps expected = {{"t8", Role::Rough},
                            {"t2", Role::Surrogate},
                            {"t2", Role::Surrogate},
                            {"t2", Role::Rest},
                            {"t1", Role::Rest}};
    EXPECT_EQ(stepsOf(planPocket("bossed_pocket", SurrogateRule::Single)), expected);
}

// The paper has the lumps cleared at once. The 0.2 in cutter is quicker where it takes them with all the
// rest.
TEST(PaperCase, LumpsLeftToTheNextToolTakeLess) {
    const PlannedFeature at_once = planPocket("bossed_pocket", SurrogateRule::Single);
    const PlannedFeature later = planPocket("bossed_pocket", SurrogateRule::Sequence);
    EXPECT_EQ(stepsOf(later), (Steps{{"t8", Role::Rough}, {"t2", Role::Rest}, {"t1", Role::Rest}}));
    EXPECT_LT(later.sequence.motion_s, at_once.sequence.motion_s);
    EXPECT_TRUE(later.sequence.way.front().alone);
    EXPECT_TRUE(later.sequence.residual.empty());
}

// Table 4 has other tools, too, in other places: 0.375, 0.2, 0.125 in. Here it is 0.5, 0.3125, 0.125 in.
TEST_P(PaperCaseByRule, WithoutBossesTheToolsAreOthersAndTheTimeIsLess) {
    const PlannedFeature with = planPocket("bossed_pocket", GetParam());
    const PlannedFeature without = planPocket("pocket_without_bosses", GetParam());
    EXPECT_EQ(stepsOf(without), (Steps{{"t8", Role::Rough}, {"t4", Role::Rest}, {"t1", Role::Rest}}));
    EXPECT_LT(without.sequence.time_s, with.sequence.time_s);
    EXPECT_NEAR(with.feature.area_mm2, without.feature.area_mm2, 1e-6 * with.feature.area_mm2);
}

// Both tables print 0.683 min for the last tool after 0.2 in: what t1 finishes after t2 does not depend on
// who came before [DSouza2006, eq. 8], nor on bosses that t2 and t1 both reach past.
TEST_P(PaperCaseByRule, TheLastEdgeIsTheSameWithAndWithoutBosses) {
    const auto lastEdge = [](const PlannedFeature& pocket) {
        for (const DagEdge& edge : pocket.sequence.edges)
            if (edge.from.name() == "t2" && edge.to.name() == "t1") return edge;
        ADD_FAILURE() << "t2 > t1 was not weighed";
        return DagEdge{};
    };
    const DagEdge with = lastEdge(planPocket("bossed_pocket", GetParam()));
    const DagEdge without = lastEdge(planPocket("pocket_without_bosses", GetParam()));
    EXPECT_GT(with.region_area_mm2, 0);
    EXPECT_NEAR(with.region_area_mm2, without.region_area_mm2, 1e-6 * with.region_area_mm2);
    EXPECT_NEAR(with.totals.cut_length_mm, without.totals.cut_length_mm, 1e-6 * with.totals.cut_length_mm);
}

// Table 4: 0.375, 0.2, 0.125 in. A pocket that asks for these: corridors too narrow for 0.4 in, with slots
// too narrow for 0.25 and for 0.2 in.
TEST_P(PaperCaseByRule, ThreeWidthsOfCorridorTakeTheToolsOfTable4) {
    const Region corridors =
        unite(std::vector<Region>{makeRectangle({0, 0}, {80, 9.9}), makeRectangle({0, 0}, {9.9, 60}),
                                  makeRectangle({70.1, 0}, {80, 60})},
              kTol);
    const Region slots =
        unite(std::vector<Region>{makeRectangle({20, 5}, {25.6, 40}), makeRectangle({35, 5}, {40.6, 40}),
                                  makeRectangle({50, 5}, {53.4, 40})},
              kTol);
    const ToolLibrary library =
        readToolLibrary(std::string(STEPMILL_SOURCE_DIR) + "/samples/dsouza2006_tools.json");
    SequenceOptions options = test::inAluminium();
    options.surrogates = GetParam();
    const ToolSequence sequence = sequenceTools(test::makePocket(unite(corridors, slots, kTol), 6), library,
                                                defaultMachine(), options, kTol);
    Steps steps;
    for (const SequenceStep& step : sequence.steps)
        steps.emplace_back(step.tool_id, step.role);
    EXPECT_EQ(steps, (Steps{{"t5", Role::Rough}, {"t2", Role::Rest}, {"t1", Role::Rest}}));
}

INSTANTIATE_TEST_SUITE_P(BothRules, PaperCaseByRule,
                         testing::Values(SurrogateRule::Single, SurrogateRule::Sequence));

}  // namespace
}  // namespace stepmill
