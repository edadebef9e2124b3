// [Li2001, Table 1] on our die cavity: the pattern chosen in each layer is the quickest one there.

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/plan/plan.h"
#include "support/clearing_tasks.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

const Tolerances kTol;

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

TEST(DieCavityLayers, AreCutInTheBestOfBothPatternsEach) {
    const ToolLibrary library = defaultToolLibrary();
    const Machine machine = defaultMachine();
    const Part part = readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/die_cavity.step").front();
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

}  // namespace
}  // namespace stepmill::test
