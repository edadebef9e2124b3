#include <algorithm>

#include <fmt/format.h>

#include "access/collision.h"
#include "access/entry.h"
#include "access/lazy_diagram.h"
#include "access/slivers.h"
#include "access/suitability.h"
#include "access/swept.h"
#include "stepmill/access/access.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

using access::Blocker;

/// C_t before the question how to get there.
std::vector<Region> centreComponents(const FeatureGround& ground, double radius_mm) {
    // Closed all round, a centre outside the target would have to reach over a wall.
    if (ground.walledIn()) return components(ground.targetOffset(-radius_mm));
    const Tolerances& tol = ground.tolerances();
    const Region centres = subtract(ground.targetOffset(radius_mm), ground.obstructionOffset(radius_mm), tol);
    return components(access::withoutSliverComponents(centres, tol));
}

Exclusion tooWide(const FeatureGround& ground, const ToolAssembly& tool) {
    return {ExclusionReason::TooWide,
            fmt::format("is {:.4g} mm wide, the widest cutter that fits is {:.4g} mm", tool.diameter_mm,
                        ground.widestCutterMm())};
}

Exclusion noEntry(const ToolAssembly& tool) {
    return {ExclusionReason::NoEntry,
            fmt::format(
                "fits, but there is no open edge, no room for a helix or a straight ramp of {:.4g} mm, and "
                "it does not cut to its centre",
                tool.diameter_mm)};
}

/// Fills in the collision-free area; the exclusion when it lacks something of the coverable area.
std::optional<Exclusion> checkCollisions(const FeatureGround& ground, const ToolAssembly& tool,
                                         AccessibleArea& found) {
    found.collision_free_area_mm2 = found.coverable_area_mm2;
    const std::vector<Blocker> blockers = access::blockers(ground.feature(), tool);
    if (blockers.empty()) return std::nullopt;
    const Tolerances& tol = ground.tolerances();
    const Region centres = access::collisionFreeCentres(ground, blockers, found.free_centres);
    const Region swept = access::swept(centres, found.radius_mm, tol);
    const Region lost = access::withoutSliverComponents(subtract(found.coverable, swept, tol), tol);
    if (lost.empty()) return std::nullopt;
    found.collision_free_area_mm2 = std::max(0.0, found.coverable_area_mm2 - area(lost));
    const double depth_mm = ground.feature().depth_mm();
    if (swept.empty() && tool.stick_out_mm < depth_mm)
        return Exclusion{
            ExclusionReason::TooShort,
            fmt::format("reaches {:.4g} mm, the floor is {:.4g} mm deep", tool.stick_out_mm, depth_mm)};
    const Blocker& lowest =
        *std::min_element(blockers.begin(), blockers.end(),
                          [](const auto& a, const auto& b) { return a.height_mm < b.height_mm; });
    return Exclusion{
        ExclusionReason::HolderCollision,
        fmt::format("shank or holder ({:.4g} mm wide at {:.4g} mm over the tip) would touch standing "
                    "material over {:.4g} of {:.4g} mm2",
                    2 * lowest.radius_mm, lowest.height_mm, area(lost), found.coverable_area_mm2)};
}

/// Keeps the components the tool can get into. Were any left out?
bool keepEnterable(const FeatureGround& ground, const ToolAssembly& tool, std::vector<Region> centres,
                   AccessibleArea& found) {
    bool all = true;
    for (Region& component : centres) {
        const auto entry = access::findEntry(ground, tool, component);
        all = all && entry.has_value();
        if (!entry) continue;
        found.entries.push_back(*entry);
        for (Loop& loop : component.loops)
            found.free_centres.loops.push_back(std::move(loop));
    }
    return all;
}

void measureAreas(const FeatureGround& ground, bool all_components, AccessibleArea& found) {
    const Tolerances& tol = ground.tolerances();
    // The target's own diagram answers where nothing was left out and no two discs meet across a neck.
    const bool is_opening = ground.walledIn() && all_components && found.entries.size() == 1;
    found.accessible = is_opening ? ground.targetOpening(found.radius_mm)
                                  : access::swept(found.free_centres, found.radius_mm, tol);
    found.coverable =
        ground.walledIn() ? found.accessible : intersect(found.accessible, ground.feature().target, tol);
    found.accessible_diagram = std::make_shared<LazyDiagram>();
    found.coverable_area_mm2 = area(found.coverable);
    found.accessible_area_mm2 = found.coverable_area_mm2;
    found.access_volume_mm3 = found.coverable_area_mm2 * ground.feature().depth_mm();
}

}  // namespace

AccessibleArea accessibleArea(const FeatureGround& ground, const ToolAssembly& tool,
                              const std::string& material) {
    AccessibleArea found;
    found.tool_id = tool.id;
    found.radius_mm = tool.radius_mm();
    if (tool.isDrill()) {
        found.excluded = access::unsuitableDrill(ground, tool, material);
        return found;
    }
    found.excluded = access::unsuitable(ground, tool, material);
    if (found.excluded && found.excluded->reason == ExclusionReason::WrongType) return found;

    const auto exclude = [&](Exclusion why) {
        if (!found.excluded) found.excluded = std::move(why);
    };
    std::vector<Region> centres = centreComponents(ground, found.radius_mm);
    if (centres.empty()) {
        exclude(tooWide(ground, tool));
        return found;
    }
    const bool all_components = keepEnterable(ground, tool, std::move(centres), found);
    if (found.free_centres.empty()) {
        exclude(noEntry(tool));
        return found;
    }
    measureAreas(ground, all_components, found);
    if (auto collision = checkCollisions(ground, tool, found)) exclude(std::move(*collision));
    return found;
}

}  // namespace stepmill
