// Where residuals stand in the part, and whether later setups take them away.

#include "plan/residual_prisms.h"

#include "stepmill/plan/removed.h"
#include "stepmill/planar/edge.h"

namespace stepmill {
namespace {

/// Heights in a prism at which points are taken, as shares.
constexpr double kHeights[] = {0.17, 0.5, 0.83};
/// Points this far inside the boundary [mm], or a tenth of the edge.
constexpr double kInsideMm = 1e-3;

bool inside(const SetupPrism& where, const Vec3& in_part) {
    const Vec3 p = where.setup->part_to_setup * in_part;
    return where.prism.bottom_z_mm < p.z() && p.z() < where.prism.top_z_mm &&
           contains(where.prism.region, p.head<2>());
}

/// A point inside the region near the middle of each edge: cusps in corners have no other sure points.
std::vector<Vec2> pointsIn(const Region& region) {
    std::vector<Vec2> points;
    for (const auto& [from, segment] : eachEdge(region)) {
        const Vec2 along = tangentAt(from, segment, 0.5);
        const double in = std::min(kInsideMm, length(from, segment) / 10);
        points.push_back(pointAt(from, segment, 0.5) + in * leftOf(along));
    }
    return points;
}

}  // namespace

std::vector<ResidualPrism> residualPrisms(const std::vector<PlannedFeature>& features) {
    std::vector<ResidualPrism> prisms;
    for (const PlannedFeature& planned : features) {
        const Residual* below = belowReach(planned);
        for (const Residual& residual : planned.sequence.residual) {
            if (residual.region.empty() || residual.area_mm2 <= 0) continue;
            const double height = meanHeightMm(residual);
            // What covers the whole depth stands on the feature's floor, what the tools leave on theirs.
            const bool whole =
                standsOver(residual, planned.feature.depth_mm()) || planned.sequence.steps.empty();
            const double floor =
                &residual == below || whole ? planned.feature.floor_z_mm : planned.sequence.floor_z_mm;
            prisms.push_back({residual.reason,
                              residual.volume_mm3,
                              {residual.region, floor + height, floor},
                              &residual,
                              &planned});
        }
    }
    return prisms;
}

double shareOutside(const Setup& setup, const Prism& prism, const std::vector<SetupPrism>& others) {
    const Eigen::Isometry3d back = setup.part_to_setup.inverse();
    int all = 0;
    int outside = 0;
    for (const Vec2& point : pointsIn(prism.region)) {
        for (const double height : kHeights) {
            const double z = prism.bottom_z_mm + height * (prism.top_z_mm - prism.bottom_z_mm);
            const Vec3 in_part = back * Vec3(point.x(), point.y(), z);
            ++all;
            outside += std::none_of(others.begin(), others.end(),
                                    [&](const SetupPrism& other) { return inside(other, in_part); });
        }
    }
    return all > 0 ? static_cast<double>(outside) / all : 1;
}

}  // namespace stepmill
