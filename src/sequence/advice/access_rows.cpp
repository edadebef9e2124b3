#include <tbb/parallel_for.h>

#include "sequence/dag/candidate.h"
#include "sequence/holder/tool_areas.h"
#include "stepmill/core/units.h"
#include "stepmill/sequence/advice/area_models.h"
#include "stepmill/sequence/advice/ranking.h"
#include "stepmill/sequence/machine_limits.h"

namespace stepmill {
namespace {

constexpr double kMm3PerCm3 = 1000;

/// Of the access volume, what the whole tool may reach.
double clearVolumeMm3(const ToolReach& reach, double depth_mm) {
    const Exclusion* excluded = reach.exclusion();
    if (excluded == nullptr) return reach.cutter.access_volume_mm3;
    if (excluded->reason != ExclusionReason::HolderCollision) return 0;
    return reach.collision_free_area_mm2 * depth_mm;
}

bool leavesFlatFloor(const ToolAssembly& tool) {
    return tool.type == ToolType::Flat || tool.type == ToolType::Face;
}

}  // namespace

std::vector<AccessRow> accessTable(const std::vector<Feature>& features, const ToolLibrary& library,
                                   const Machine& machine, const SequenceOptions& options,
                                   const Tolerances& tol) {
    std::vector<const ToolAssembly*> tools;
    std::vector<AccessRow> rows;
    for (const ToolAssembly& tool : library.tools) {
        const CuttingData* cutting = tool.cuttingFor(options.material);
        if (!leavesFlatFloor(tool) || cutting == nullptr) continue;
        const double rate_mm3_per_s = removalRateMm3PerS(limitedBy(machine, *cutting));
        if (rate_mm3_per_s <= 0) continue;
        tools.push_back(&tool);
        rows.push_back({tool.id, tool.diameter_mm, 0, rate_mm3_per_s * kSecondsPerMinute / kMm3PerCm3, 0});
    }
    for (const Feature& feature : features) {
        const FeatureGround ground(feature, tol);
        tbb::parallel_for(std::size_t{0}, tools.size(), [&](std::size_t i) {
            const ToolReach reach = reachFor(ground, *tools[i], options);
            rows[i].volume_cm3 += reach.cutter.access_volume_mm3 / kMm3PerCm3;
            *rows[i].clear_volume_cm3 += clearVolumeMm3(reach, feature.depth_mm()) / kMm3PerCm3;
        });
    }
    return rows;
}

}  // namespace stepmill
