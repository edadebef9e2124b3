#include "sequence/holder/tool_areas.h"

#include "stepmill/access/collision.h"

namespace stepmill {

ToolReach reachFor(const FeatureGround& ground, const ToolAssembly& tool, const SequenceOptions& options) {
    ToolReach reach = toolReach(ground, tool, options.material);
    if (options.clear_of_own_material)
        if (auto trouble = access::ownMaterialTrouble(ground, tool, reach)) reach.use = std::move(*trouble);
    return reach;
}

void addHolder(const Feature& feature, const ToolAssembly& tool, ClearingTask& clearing) {
    const ToolAssembly shortest =
        tool.stick_out_range ? setTo(tool, tool.stick_out_range->shortest_mm) : tool;
    for (const access::Blocker& blocker : access::blockers(feature, shortest))
        clearing.kept_off.push_back({feature.obstacles[blocker.obstacle].section, blocker.radius_mm});
    clearing.free_reach_mm = access::freeReachMm(shortest);
}

}  // namespace stepmill
