#include "sequence/holder/tool_areas.h"

#include "stepmill/access/collision.h"
#include "stepmill/access/lumps.h"
#include "stepmill/feature/heights.h"

namespace stepmill {

ToolReach reachFor(const FeatureGround& ground, const ToolAssembly& tool, const SequenceOptions& options) {
    ToolReach reach = toolReach(ground, tool, options.material);
    if (options.clear_of_own_material)
        if (auto trouble = access::ownMaterialTrouble(ground, tool, reach)) reach.use = std::move(*trouble);
    return reach;
}

Surroundings surroundingsOf(const Feature& feature) {
    Surroundings around{feature.skirt, {}, highestMm(feature)};
    if (const auto above = access::obstacleAbove(feature.obstacles, feature.top_z_mm, kSameHeightMm))
        around.above = feature.obstacles[*above].section;
    return around;
}

Surroundings within(const Surroundings& around, const Box2& box, const Tolerances& tol) {
    return {within(around.skirt, box, tol), within(around.above, box, tol), around.stands_to_mm};
}

ClearingTask clearingTaskOf(const Feature& feature, const Surroundings& around, const CutterArea& reach,
                            double retract_z_mm) {
    ClearingTask clearing;
    clearing.free_centres = reach.free_centres;
    clearing.target = feature.target;
    clearing.obstruction = reach.obstructionIn(feature);
    clearing.top_z_mm = feature.top_z_mm;
    clearing.floor_z_mm = feature.floor_z_mm;
    clearing.retract_z_mm = retract_z_mm;
    clearing.skirt = around.skirt;
    clearing.stands_to_mm = around.stands_to_mm;
    clearing.stands_above = around.above;
    return clearing;
}

void addHolder(const Feature& feature, const ToolAssembly& tool, ClearingTask& clearing) {
    const ToolAssembly shortest =
        tool.stick_out_range ? setTo(tool, tool.stick_out_range->shortest_mm) : tool;
    for (const access::Blocker& blocker : access::blockers(feature, shortest))
        clearing.kept_off.push_back({feature.obstacles[blocker.obstacle].section, blocker.radius_mm});
    clearing.free_reach_mm = access::freeReachMm(shortest);
}

}  // namespace stepmill
