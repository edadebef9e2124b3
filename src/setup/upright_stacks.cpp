#include "setup/upright_stacks.h"

#include "stepmill/planar/boolean.h"

namespace stepmill::setup {

namespace {

/// Heights closer than this are one [mm].
constexpr double kSameHeightMm = 1e-6;

Box2 boxOf(const Prism& prism) {
    return boundingBox(prism.region);
}

bool standsUnder(const Prism& lower, const Prism& upper, const Tolerances& tol) {
    return std::abs(lower.top_z_mm - upper.bottom_z_mm) < kSameHeightMm &&
           boxOf(lower).overlaps(boxOf(upper)) && covers(upper.region, lower.region, tol.linear_mm, tol);
}

/// Leaves out what rounding leaves between walls that coincide.
Region withoutCrumbs(const Region& region, const Tolerances& tol) {
    Region kept;
    for (const Region& component : components(region)) {
        if (area(component) <= std::max(tol.area_mm2, tol.linear_mm * perimeter(component))) continue;
        kept.loops.insert(kept.loops.end(), component.loops.begin(), component.loops.end());
    }
    return kept;
}

}  // namespace

std::vector<Prism> uprightStacks(std::vector<Prism> prisms, const Tolerances& tol) {
    // Lowest first: a prism grown through one upper neighbour goes on through the next.
    std::stable_sort(prisms.begin(), prisms.end(), [](const Prism& a, const Prism& b) {
        return a.bottom_z_mm != b.bottom_z_mm ? a.bottom_z_mm < b.bottom_z_mm : a.top_z_mm < b.top_z_mm;
    });
    for (std::size_t i = 0; i < prisms.size(); ++i) {
        for (std::size_t j = i + 1; j < prisms.size(); ++j) {
            if (prisms[j].region.empty() || !standsUnder(prisms[i], prisms[j], tol)) continue;
            prisms[i].top_z_mm = prisms[j].top_z_mm;
            prisms[j].region = withoutCrumbs(subtract(prisms[j].region, prisms[i].region, tol), tol);
        }
    }
    std::erase_if(prisms, [](const Prism& prism) { return prism.region.empty(); });
    return prisms;
}

}  // namespace stepmill::setup
