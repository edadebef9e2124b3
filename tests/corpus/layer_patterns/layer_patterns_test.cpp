// [Li2001, Table 1] on our dies: the pattern chosen in each layer is the quickest one there.

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/plan/plan.h"
#include "support/clearing_tasks.h"
#include "support/run_program.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

using test::kTol;

/// Times of one layer by pattern, and of the choice.
struct LayerTimes {
    double parallel_s = 0;
    double offset_s = 0;
    double chosen_s = 0;
};

LayerTimes timesOf(ClearingTask task, const ToolAssembly& tool, const Machine& machine) {
    const CuttingData& cutting = *tool.cuttingFor("aluminium");
    const auto time = [&](Pattern pattern) {
        task.pattern = pattern;
        return clearArea(task, tool, cutting, machine, kTol).totals.time_s();
    };
    // Without islands the paper's stock-offset is contour-parallel from outside in.
    const double offset = std::min(
        {time(Pattern::StockOffset), time(Pattern::ContourOutsideIn), time(Pattern::ContourInsideOut)});
    return {std::min(time(Pattern::Zigzag), time(Pattern::OneWay)), offset, time(Pattern::Best)};
}

Part diePart(const std::string& name) {
    return readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + name + ".step").front();
}

class DieLayers : public testing::TestWithParam<const char*> {};
class RoughedLayers : public testing::TestWithParam<const char*> {};

TEST_P(DieLayers, AreCutInTheBestOfBothPatternsEach) {
    const ToolLibrary library = defaultToolLibrary();
    const Machine machine = defaultMachine();
    const Part part = diePart(GetParam());
    const FeatureSet features = recogniseFeatures(slice(chooseSetups(part, {}).front(), kTol), kTol);
    ASSERT_GE(features.features.size(), 3U);
    int compared = 0;
    for (const ToolAssembly& tool : library.tools) {
        if (tool.isDrill() || tool.cuttingFor("aluminium") == nullptr) continue;
        LayerTimes sum;
        double best_of_both = 0;
        for (const Feature& feature : features.features) {
            const FeatureGround ground(feature, kTol);
            const ToolReach reach = toolReach(ground, tool, "aluminium");
            if (reach.exclusion()) continue;
            const DecomposedArea all = decomposedArea(ground, nullptr, reach.cutter);
            const LayerTimes layer = timesOf(taskOf(feature, reach.cutter, all, machine), tool, machine);
            sum.parallel_s += layer.parallel_s;
            sum.offset_s += layer.offset_s;
            sum.chosen_s += layer.chosen_s;
            best_of_both += std::min(layer.parallel_s, layer.offset_s);
            ++compared;
        }
        EXPECT_LE(sum.chosen_s, best_of_both * (1 + 1e-5)) << tool.id;
        if (sum.chosen_s > 0)
            std::printf("%-6s offset %7.2f s, parallel %7.2f s, best of both %7.2f s, chosen %7.2f s\n",
                        tool.id.c_str(), sum.offset_s, sum.parallel_s, best_of_both, sum.chosen_s);
    }
    EXPECT_GE(compared, 20);
}

/// Seconds of all paths when every layer is gone over by one pattern, or each by its best.
double pathSeconds(const Part& part, Pattern pattern) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.sequence.pattern = pattern;
    request.roughing = FinishAllowance{0.5, 0.5};
    request.common_ground = false;  // which ground pays depends on the patterns
    const Plan plan = planPart(part, request, defaultToolLibrary(), defaultMachine(), kTol);
    double sum_s = 0;
    for (const PlannedSetup& setup : plan.setups)
        for (const Operation& operation : setup.operations)
            sum_s += operation.path.totals.time_s();
    return sum_s;
}

TEST_P(RoughedLayers, TakeNoLongerThanWithOnePatternForAllOfThem) {
    const Part part = diePart(GetParam());
    const double best_s = pathSeconds(part, Pattern::Best);
    EXPECT_GT(best_s, 0);
    for (const Pattern pattern : {Pattern::ContourInsideOut, Pattern::ContourOutsideIn, Pattern::StockOffset,
                                  Pattern::Zigzag, Pattern::OneWay}) {
        const double one_s = pathSeconds(part, pattern);
        std::printf("%-18s %-36s %7.2f s, best of each layer %7.2f s\n", GetParam(),
                    toString(pattern).c_str(), one_s, best_s);
        EXPECT_LE(best_s, one_s * (1 + 1e-5)) << toString(pattern);
    }
}

INSTANTIATE_TEST_SUITE_P(Parts, DieLayers, testing::Values("die_cavity"));
INSTANTIATE_TEST_SUITE_P(Slow, DieLayers, testing::Values("die_with_islands"));
INSTANTIATE_TEST_SUITE_P(Parts, RoughedLayers, testing::Values("die_cavity"));
INSTANTIATE_TEST_SUITE_P(Slow, RoughedLayers, testing::Values("mold_core"));

}  // namespace
}  // namespace stepmill::test
