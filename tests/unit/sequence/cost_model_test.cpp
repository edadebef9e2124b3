#include <gtest/gtest.h>

#include "sequence/dag/candidate.h"
#include "stepmill/sequence/machine_limits.h"
#include "support/sample_feature.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

using test::kTol;

ToolLibrary fiveMills() {
    return makeLibrary({makeMill(25, 2200, 6), makeMill(16, 2000, 5), makeMill(10, 1500, 4),
                        makeMill(6, 800, 3), makeMill(3, 400, 1)});
}

Feature sharpPocket() {
    return makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(120, 80), 1.5), 15);
}

/// The area model's own optimum over the same areas.
std::vector<std::string> byAreaModel(const ToolSequence& sequence, const ToolLibrary& library,
                                     CostModel model, const Feature& feature, const Machine& machine) {
    std::vector<AreaModelTool> tools;
    for (const ToolReach& reach : sequence.tools) {
        const ToolAssembly& tool = library.tool(reach.tool_id);
        tools.push_back(areaModelTool(tool.radius_mm(), reach.cleared().coverable_area_mm2,
                                      feature.depth_mm(), limitedBy(machine, tool.cutting.front())));
    }
    const CheapestPath path = model == CostModel::Lim
                                  ? cheapestByLim(tools, machine.tool_change_s)
                                  : cheapestByYao(tools, {machine.tool_change_s, yaoFactorSPerMm(tools)});
    std::vector<std::string> ids;
    for (const int node : path.tools)
        ids.push_back(sequence.tools[node].tool_id);
    return ids;
}

TEST(CostModel, ChoosesAsThePapersModelsDo) {
    const Feature feature = sharpPocket();
    const ToolLibrary library = fiveMills();
    for (const double change_s : {1.0, 20.0, 200.0}) {
        Machine machine = makeMachine();
        machine.tool_change_s = change_s;
        for (const CostModel model : {CostModel::Lim, CostModel::Yao}) {
            SequenceOptions options = inAluminium();
            options.cost_model = model;
            const ToolSequence sequence = sequenceTools(feature, library, machine, options, kTol);
            EXPECT_EQ(toolsOf(sequence), byAreaModel(sequence, library, model, feature, machine))
                << toString(model) << ", " << change_s << " s";
        }
    }
}

TEST(CostModel, TimesAreThoseOfRealPathsByAnyModel) {
    const Feature feature = sharpPocket();
    const ToolLibrary library = fiveMills();
    const ToolSequence by_paths = sequenceTools(feature, library, makeMachine(), inAluminium(), kTol);
    for (const CostModel model : {CostModel::Lim, CostModel::Yao}) {
        SequenceOptions options = inAluminium();
        options.cost_model = model;
        const ToolSequence sequence = sequenceTools(feature, library, makeMachine(), options, kTol);
        double sum_s = 0;
        for (const SequenceStep& step : sequence.steps)
            sum_s += step.path.totals.time_s() + makeMachine().tool_change_s;
        EXPECT_NEAR(sequence.time_s, sum_s, 1e-9);
        EXPECT_GE(sequence.time_s, by_paths.time_s - 1e-9) << "the paths' own choice is the optimum on paths";
        EXPECT_GE(sequence.time_s, sequence.lower_bound_s);
    }
}

TEST(CostModel, CountsAccelerationWhereTheMachineGivesIt) {
    const Feature feature = sharpPocket();
    const ToolLibrary library = fiveMills();
    Machine machine = makeMachine();
    const ToolSequence plain = sequenceTools(feature, library, machine, inAluminium(), kTol);
    EXPECT_DOUBLE_EQ(plain.motion_s, plain.time_s);
    machine.acceleration_mm_per_s2 = 100;
    const ToolSequence slow = sequenceTools(feature, library, machine, inAluminium(), kTol);
    EXPECT_GT(slow.motion_s, slow.time_s);
    EXPECT_GE(slow.time_s, plain.time_s - 1e-9);
    double sum_s = 0;
    for (const SequenceStep& step : slow.steps)
        sum_s += motionTimeS(step.path, machine) + machine.tool_change_s;
    EXPECT_NEAR(slow.motion_s, sum_s, 1e-9);
}

}  // namespace
}  // namespace stepmill::test
