#include <tbb/parallel_for.h>

#include "sequence/candidate.h"
#include "stepmill/core/units.h"
#include "stepmill/sequence/area_models.h"
#include "stepmill/sequence/ranking.h"

namespace stepmill {
namespace {

constexpr double kMm3PerCm3 = 1000;

double accessVolumeMm3(const FeatureGround& ground, const ToolAssembly& tool, const std::string& material) {
    const AccessibleArea area = accessibleArea(ground, tool, material);
    if (!area.excluded) return area.access_volume_mm3;
    const auto limited = limitedArea(ground, tool, area);
    return limited ? limited->access_volume_mm3 : 0;
}

}  // namespace

std::vector<AccessRow> accessTable(const std::vector<Feature>& features, const ToolLibrary& library,
                                   const Machine& machine, const std::string& material,
                                   const Tolerances& tol) {
    std::vector<const ToolAssembly*> tools;
    std::vector<AccessRow> rows;
    for (const ToolAssembly& tool : library.tools) {
        const CuttingData* cutting = tool.cuttingFor(material);
        if (tool.isDrill() || cutting == nullptr) continue;
        const double rate_mm3_per_s = removalRateMm3PerS(limitedBy(machine, *cutting));
        if (rate_mm3_per_s <= 0) continue;
        tools.push_back(&tool);
        rows.push_back({tool.id, tool.diameter_mm, 0, rate_mm3_per_s * kSecondsPerMinute / kMm3PerCm3});
    }
    for (const Feature& feature : features) {
        const FeatureGround ground(feature, tol);
        tbb::parallel_for(std::size_t{0}, tools.size(), [&](std::size_t i) {
            rows[i].volume_cm3 += accessVolumeMm3(ground, *tools[i], material) / kMm3PerCm3;
        });
    }
    return rows;
}

}  // namespace stepmill
