#include "access/collision.h"

#include "stepmill/planar/boolean.h"

namespace stepmill::access {
namespace {

std::optional<std::size_t> obstacleAt(const Feature& feature, double z_mm) {
    for (std::size_t i = 0; i < feature.obstacles.size(); ++i)
        if (feature.obstacles[i].bottom_z_mm <= z_mm && z_mm < feature.obstacles[i].top_z_mm) return i;
    return std::nullopt;
}

}  // namespace

std::vector<Blocker> blockers(const Feature& feature, const ToolAssembly& tool) {
    std::vector<Blocker> found;
    const auto consider = [&](const HolderCylinder& cylinder) {
        if (cylinder.diameter_mm <= tool.diameter_mm) return;
        if (const auto obstacle = obstacleAt(feature, feature.floor_z_mm + cylinder.bottom_mm))
            found.push_back({*obstacle, cylinder.diameter_mm / 2, cylinder.bottom_mm});
    };
    consider(tool.shank);
    for (const HolderCylinder& cylinder : tool.holder)
        consider(cylinder);
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

}  // namespace stepmill::access
