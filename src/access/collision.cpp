#include "stepmill/access/collision.h"

#include <algorithm>

#include <fmt/format.h>

#include "stepmill/access/slivers.h"
#include "stepmill/access/swept.h"
#include "stepmill/feature/heights.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/edge_index.h"
#include "stepmill/planar/nearer_than.h"

namespace stepmill::access {
namespace {

/// A cylinder that comes into standing material by less than this share of the gouge budget touches it.
constexpr double kTouchShare = 0.5;

/// The axis goes no farther than this beyond the ground that its centres are asked for: entries lie beside it
/// [mm].
constexpr double kBesideMm = 2;

/// The blocker's obstacle grown by that, as far as it tells of the place. Obstacles are shadows of the whole
/// part: beside small ground the few edges near it are grown, else all of them once for all tools.
Region grownNear(const FeatureGround& ground, const Blocker& blocker, double by_mm, const Box2& place) {
    const Region& section = ground.feature().obstacles.at(blocker.obstacle).section;
    const Box2 near = grown(place, by_mm + kBesideMm);
    const std::vector<Edge> edges = edgesOf(section);
    const auto in_reach = static_cast<std::size_t>(std::count_if(
        edges.begin(), edges.end(), [&](const Edge& edge) { return edge.box.intersects(near); }));
    if (2 * in_reach > edges.size()) return ground.obstacleOffset(blocker.obstacle, by_mm);
    const Region part = intersect(section, makeRectangle(near.min(), near.max()), ground.tolerances());
    return part.empty() ? part : offset(part, by_mm, ground.tolerances());
}

}  // namespace

std::optional<std::size_t> obstacleAbove(const std::vector<Obstacle>& obstacles, double z_mm,
                                         double rounding_mm) {
    for (std::size_t i = 0; i < obstacles.size(); ++i)
        if (z_mm < obstacles[i].top_z_mm - rounding_mm) return i;
    return std::nullopt;
}

std::vector<HolderCylinder> cylindersOf(const ToolAssembly& tool) {
    std::vector<HolderCylinder> found = keptOffHolder(tool);
    found.insert(found.begin(), tool.shank);
    std::erase_if(found,
                  [&](const HolderCylinder& cylinder) { return cylinder.diameter_mm <= tool.diameter_mm; });
    return found;
}

bool isOfHolder(const ToolAssembly& tool, const HolderCylinder& cylinder) {
    return cylinder.top_mm > tool.stick_out_mm;
}

double clearanceAround(const ToolAssembly& tool, const HolderCylinder& cylinder) {
    return isOfHolder(tool, cylinder) ? tool.holder_clearance_mm : 0;
}

double freeReachMm(const ToolAssembly& tool) {
    double reach_mm = tool.stick_out_mm;
    for (const HolderCylinder& cylinder : cylindersOf(tool))
        reach_mm = std::min(reach_mm, cylinder.bottom_mm);
    return reach_mm;
}

std::vector<Blocker> blockers(const Feature& feature, const ToolAssembly& tool) {
    std::vector<Blocker> found;
    for (const HolderCylinder& cylinder : cylindersOf(tool)) {
        const double bottom_z_mm = feature.floor_z_mm + cylinder.bottom_mm;
        if (const auto obstacle = obstacleAbove(feature.obstacles, bottom_z_mm, kSameHeightMm))
            found.push_back({*obstacle, cylinder.diameter_mm / 2, cylinder.bottom_mm});
    }
    return found;
}

Region collisionFreeCentres(const FeatureGround& ground, const std::vector<Blocker>& blockers,
                            Region centres) {
    for (const Blocker& blocker : blockers) {
        if (centres.empty()) break;
        const Box2 place = boundingBox(centres);
        centres =
            subtract(centres, grownNear(ground, blocker, blocker.radius_mm, place), ground.tolerances());
    }
    return centres;
}

Feature withoutHolder(const FeatureGround& ground, const std::vector<Blocker>& blockers, double radius_mm) {
    const Tolerances& tol = ground.tolerances();
    std::vector<Region> kept_off{ground.feature().obstruction};
    // Centres lie within the cutter's radius of the target, and what it sweeps within another.
    const Box2 place = grown(boundingBox(ground.feature().target), 2 * radius_mm);
    for (const Blocker& blocker : blockers)
        kept_off.push_back(grownNear(ground, blocker, blocker.radius_mm - radius_mm, place));
    Feature feature = ground.feature();
    feature.obstruction = unite(kept_off, tol);
    feature.target = subtract(feature.target, feature.obstruction, tol);
    feature.area_mm2 = area(feature.target);
    feature.volume_mm3 = feature.area_mm2 * feature.depth_mm();
    feature.obstacles.clear();
    return feature;
}

bool meetsOwnMaterial(const FeatureGround& ground, const ToolAssembly& tool, const Region& centres) {
    const Tolerances& tol = ground.tolerances();
    double reach_mm = 0;
    for (const HolderCylinder& cylinder : cylindersOf(tool))
        if (cylinder.bottom_mm < ground.feature().depth_mm() - kSameHeightMm)
            reach_mm = std::max(reach_mm, cylinder.diameter_mm / 2);
    if (reach_mm <= 0) return false;
    for (const Region& component : components(centres)) {
        const Region left = withoutSliverComponents(
            subtract(ground.feature().target, swept(component, tool.radius_mm(), tol), tol), tol);
        if (!left.empty() && area(intersect(left, offset(component, reach_mm, tol), tol)) > tol.area_mm2)
            return true;
    }
    return false;
}

std::optional<Exclusion> ownMaterialTrouble(const FeatureGround& ground, const ToolAssembly& tool,
                                            const ToolReach& reach) {
    const double depth_mm = ground.feature().depth_mm();
    const double reach_mm = freeReachMm(tool);
    if (reach_mm >= depth_mm || tool.isDrill() || reach.cutter.free_centres.empty()) return std::nullopt;
    const Exclusion* excluded = reach.exclusion();
    const bool collides = excluded != nullptr && excluded->reason == ExclusionReason::HolderCollision;
    if (excluded != nullptr && !collides) return std::nullopt;
    if (!collides && !meetsOwnMaterial(ground, tool, reach.cutter.free_centres)) return std::nullopt;
    return Exclusion{ExclusionReason::TooShort,
                     fmt::format("leaves material of the feature that shank or holder would touch {:.4g} mm "
                                 "deep; they stay above {:.4g} mm",
                                 depth_mm, reach_mm)};
}

bool losesCentres(const FeatureGround& ground, const Blocker& blocker, const Region& centres) {
    const Tolerances& tol = ground.tolerances();
    // Strips of centres that coincide with their end are none.
    const double touching_mm = blocker.radius_mm - kTouchShare * tol.gouge_mm - tol.linear_mm;
    // Obstacles are shadows of the whole part: the few of their edges near the centres tell, where an offset
    // would be made of all.
    return isNearer(centres, EdgeIndex(centres), ground.feature().obstacles.at(blocker.obstacle).section,
                    touching_mm);
}

}  // namespace stepmill::access
