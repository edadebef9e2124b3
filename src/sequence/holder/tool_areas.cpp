#include "sequence/holder/tool_areas.h"

#include "stepmill/access/collision.h"

namespace stepmill {

AccessibleArea areaFor(const FeatureGround& ground, const ToolAssembly& tool,
                       const SequenceOptions& options) {
    AccessibleArea area = accessibleArea(ground, tool, options.material);
    if (options.clear_of_own_material)
        if (auto trouble = access::ownMaterialTrouble(ground, tool, area)) area.excluded = std::move(trouble);
    return area;
}

void addHolder(const Feature& feature, const ToolAssembly& tool, ClearingTask& clearing) {
    const ToolAssembly shortest =
        tool.stick_out_range ? setTo(tool, tool.stick_out_range->shortest_mm) : tool;
    for (const access::Blocker& blocker : access::blockers(feature, shortest))
        clearing.kept_off.push_back({feature.obstacles[blocker.obstacle].section, blocker.radius_mm});
    clearing.free_reach_mm = access::freeReachMm(shortest);
}

}  // namespace stepmill
