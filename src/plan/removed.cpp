#include "stepmill/plan/removed.h"

#include "stepmill/feature/heights.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {

double meanHeightMm(const Residual& residual) {
    return residual.area_mm2 > 0 ? residual.volume_mm3 / residual.area_mm2 : 0;
}

bool standsOver(const Residual& residual, double depth_mm) {
    return meanHeightMm(residual) >= depth_mm - kSameHeightMm;
}

const Residual* belowReach(const PlannedFeature& planned) {
    const double below_mm = planned.sequence.floor_z_mm - planned.feature.floor_z_mm;
    if (below_mm <= kSameHeightMm) return nullptr;
    // What stands beside the tools can be as high; it covers less.
    const Residual* found = nullptr;
    for (const Residual& residual : planned.sequence.residual) {
        if (residual.region.empty() || std::abs(meanHeightMm(residual) - below_mm) >= kSameHeightMm) continue;
        if (found == nullptr || residual.area_mm2 > found->area_mm2) found = &residual;
    }
    return found;
}

std::vector<Prism> removedBy(const PlannedFeature& planned, const Tolerances& tol) {
    const Feature& feature = planned.feature;
    const ToolSequence& sequence = planned.sequence;
    if (sequence.steps.empty()) return {};
    const double depth = feature.top_z_mm - sequence.floor_z_mm;
    std::vector<Region> standing;
    std::vector<const Residual*> low;
    // No part of the depth cut, however high it is.
    const Residual* below = belowReach(planned);
    for (const Residual& residual : sequence.residual) {
        if (residual.region.empty() || &residual == below) continue;
        if (standsOver(residual, depth))
            standing.push_back(residual.region);
        else if (meanHeightMm(residual) > kSameHeightMm)
            low.push_back(&residual);
    }
    Region cut = standing.empty() ? feature.target : subtract(feature.target, unite(standing, tol), tol);
    std::vector<Prism> prisms;
    for (const Residual* residual : low) {
        Region over = intersect(cut, residual->region, tol);
        if (area(over) <= tol.area_mm2) continue;
        cut = subtract(cut, residual->region, tol);
        prisms.push_back({std::move(over), feature.top_z_mm, sequence.floor_z_mm + meanHeightMm(*residual)});
    }
    if (area(cut) > tol.area_mm2) prisms.push_back({std::move(cut), feature.top_z_mm, sequence.floor_z_mm});
    return prisms;
}

std::vector<Prism> removedBy(const std::vector<PlannedFeature>& features, const Tolerances& tol) {
    std::vector<Prism> all;
    for (const PlannedFeature& planned : features)
        for (Prism& prism : removedBy(planned, tol))
            all.push_back(std::move(prism));
    return all;
}

}  // namespace stepmill
