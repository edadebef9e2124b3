#include <algorithm>

#include "sequence/dag/candidate.h"
#include "sequence/holder/tool_areas.h"
#include "stepmill/core/parallel.h"
#include "stepmill/core/units.h"
#include "stepmill/sequence/advice/area_models.h"
#include "stepmill/sequence/advice/ranking.h"
#include "stepmill/sequence/machine_limits.h"

namespace stepmill {
namespace {

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

/// The cutters that leave a flat floor and have data for the material, without volumes.
std::vector<AccessRow> emptyRows(const ToolLibrary& library, const Machine& machine,
                                 const std::string& material) {
    std::vector<AccessRow> rows;
    for (const ToolAssembly& tool : library.tools) {
        const CuttingData* cutting = tool.cuttingFor(material);
        if (!leavesFlatFloor(tool) || cutting == nullptr) continue;
        const double rate_mm3_per_s = removalRateMm3PerS(limitedBy(machine, *cutting));
        if (rate_mm3_per_s <= 0) continue;
        rows.push_back({tool.id, tool.diameter_mm, 0, rate_mm3_per_s * kSecondsPerMinute / kMm3PerCm3, 0});
    }
    return rows;
}

void addReach(AccessRow& row, const ToolReach& reach, double depth_mm) {
    row.volume_cm3 += reach.cutter.access_volume_mm3 / kMm3PerCm3;
    *row.clear_volume_cm3 += clearVolumeMm3(reach, depth_mm) / kMm3PerCm3;
}

}  // namespace

std::vector<AccessRow> accessTable(const std::vector<Feature>& features, const ToolLibrary& library,
                                   const Machine& machine, const SequenceOptions& options,
                                   const Tolerances& tol) {
    std::vector<AccessRow> rows = emptyRows(library, machine, options.material);
    for (const Feature& feature : features) {
        const FeatureGround ground(feature, tol);
        parallelFor(rows.size(), [&](std::size_t i) {
            addReach(rows[i], reachFor(ground, library.tool(rows[i].tool), options), feature.depth_mm());
        });
    }
    return rows;
}

std::vector<AccessRow> accessTable(const std::vector<ReachedFeature>& features, const ToolLibrary& library,
                                   const Machine& machine, const std::string& material) {
    std::vector<AccessRow> rows = emptyRows(library, machine, material);
    for (const ReachedFeature& feature : features)
        for (const ToolReach& reach : *feature.tools) {
            const auto row = std::find_if(rows.begin(), rows.end(),
                                          [&](const AccessRow& one) { return one.tool == reach.tool_id; });
            if (row != rows.end()) addReach(*row, reach, feature.depth_mm);
        }
    return rows;
}

}  // namespace stepmill
