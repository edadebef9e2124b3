#include "stepmill/setup/leaning_area.h"

#include <algorithm>
#include <cmath>

#include "setup/facets.h"
#include "stepmill/part/part_shape.h"

namespace stepmill {
namespace {

/// Facets whose normal is nearer to a direction, or to all across it, are flat there [sine].
constexpr double kFlatSine = 1e-3;

bool isFlatAlong(double along) {
    return std::abs(along) < kFlatSine || 1 - std::abs(along) < kFlatSine * kFlatSine;
}

}  // namespace

LeaningArea leaningArea(const Part& part, const std::vector<Setup>& setups) {
    LeaningArea area;
    for (const setup::Facet& facet : setup::coarseFacets(part.shape->solid)) {
        const Vec3 twice = (facet[1] - facet[0]).cross(facet[2] - facet[0]);
        if (twice.norm() == 0) continue;
        const Vec3 normal = twice.normalized();
        area.surface_mm2 += twice.norm() / 2;
        const auto leans = [&](const Setup& setup) { return normal.dot(setup.axis) > kFlatSine; };
        const auto is_flat = [&](const Setup& setup) { return isFlatAlong(normal.dot(setup.axis)); };
        if (std::any_of(setups.begin(), setups.end(), leans) &&
            std::none_of(setups.begin(), setups.end(), is_flat))
            area.leaning_mm2 += twice.norm() / 2;
    }
    return area;
}

}  // namespace stepmill
