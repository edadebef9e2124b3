// The cheapest sequence of cutters for one pocket, drawn by hand: no STEP file, no B-rep kernel.
// Usage: tool_sequence

#include <cstdio>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/sequence.h"

namespace {

using namespace stepmill;

/// 80 x 50 mm with 5 mm corners and a round island, 12 mm deep, in a block.
Feature pocketWithIsland(const Tolerances& tol) {
    const Region island = makeCircle({30, 25}, 8);
    Feature pocket;
    pocket.id = "pocket";
    pocket.feature_class = FeatureClass::ClosedPocket;
    pocket.target = subtract(makeRoundedRectangle({0, 0}, {80, 50}, 5), island, tol);
    pocket.obstruction = subtract(makeRectangle({-20, -20}, {100, 70}), pocket.target, tol);
    pocket.floor_z_mm = -12;
    pocket.area_mm2 = area(pocket.target);
    pocket.volume_mm3 = pocket.area_mm2 * pocket.depth_mm();
    pocket.closed_length_mm = perimeter(pocket.target);
    pocket.obstacles = {{pocket.floor_z_mm, 0, pocket.obstruction}};
    return pocket;
}

}  // namespace

int main() {
    SequenceOptions options;
    options.material = "aluminium";
    options.retract_mm = 5;
    const Tolerances tol;
    const ToolSequence sequence =
        sequenceTools(pocketWithIsland(tol), defaultToolLibrary(), defaultMachine(), options, tol);
    for (const DagEdge& edge : sequence.edges)
        std::printf("%8s > %-8s %8.1f mm2 %7.1f s\n", edge.from.empty() ? "start" : edge.from.name().c_str(),
                    edge.to.empty() ? "end" : edge.to.name().c_str(), edge.region_area_mm2, edge.time_s);
    std::printf("cheapest:");
    for (const SequenceStep& step : sequence.steps)
        std::printf(" %s", step.tool_id.c_str());
    std::printf(", %.1f s, no less than %.1f s\n", sequence.time_s, sequence.lower_bound_s);
    return sequence.steps.empty() ? 1 : 0;
}
