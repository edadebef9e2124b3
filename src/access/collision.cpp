#include "access/collision.h"

#include <algorithm>

#include "stepmill/planar/boolean.h"

namespace stepmill::access {
namespace {

/// A holder this little below the top of an obstacle only rests on rounding [mm].
constexpr double kHeightRoundingMm = 1e-6;

std::optional<std::size_t> obstacleAt(const Feature& feature, double z_mm) {
    for (std::size_t i = 0; i < feature.obstacles.size(); ++i)
        if (feature.obstacles[i].bottom_z_mm <= z_mm &&
            z_mm < feature.obstacles[i].top_z_mm - kHeightRoundingMm)
            return i;
    return std::nullopt;
}

}  // namespace

std::vector<HolderCylinder> cylindersOf(const ToolAssembly& tool) {
    std::vector<HolderCylinder> found;
    const auto consider = [&](const HolderCylinder& cylinder) {
        if (cylinder.diameter_mm > tool.diameter_mm) found.push_back(cylinder);
    };
    consider(tool.shank);
    std::for_each(tool.holder.begin(), tool.holder.end(), consider);
    return found;
}

std::vector<Blocker> blockers(const Feature& feature, const ToolAssembly& tool) {
    std::vector<Blocker> found;
    for (const HolderCylinder& cylinder : cylindersOf(tool)) {
        if (const auto obstacle = obstacleAt(feature, feature.floor_z_mm + cylinder.bottom_mm))
            found.push_back({*obstacle, cylinder.diameter_mm / 2, cylinder.bottom_mm});
    }
    return found;
}

Region collisionFreeCentres(const FeatureGround& ground, const std::vector<Blocker>& blockers,
                            Region centres) {
    for (const Blocker& blocker : blockers) {
        if (centres.empty()) break;
        centres = subtract(centres, ground.obstacleOffset(blocker.obstacle, blocker.radius_mm),
                           ground.tolerances());
    }
    return centres;
}

Feature withoutHolder(const FeatureGround& ground, const std::vector<Blocker>& blockers, double radius_mm) {
    const Tolerances& tol = ground.tolerances();
    std::vector<Region> kept_off{ground.feature().obstruction};
    for (const Blocker& blocker : blockers)
        kept_off.push_back(ground.obstacleOffset(blocker.obstacle, blocker.radius_mm - radius_mm));
    Feature feature = ground.feature();
    feature.obstruction = unite(kept_off, tol);
    feature.target = subtract(feature.target, feature.obstruction, tol);
    feature.area_mm2 = area(feature.target);
    feature.volume_mm3 = feature.area_mm2 * feature.depth_mm();
    feature.obstacles.clear();
    return feature;
}

bool losesCentres(const FeatureGround& ground, const Blocker& blocker, const Region& centres) {
    const Region clear = collisionFreeCentres(ground, {blocker}, centres);
    return area(centres) - area(clear) > ground.tolerances().area_mm2;
}

}  // namespace stepmill::access
