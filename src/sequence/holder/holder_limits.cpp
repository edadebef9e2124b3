#include "sequence/holder/holder_limits.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "sequence/dag/candidate.h"
#include "stepmill/access/lumps.h"

namespace stepmill {
namespace {

/// Going less deep must machine this much more of the feature to be worth it.
constexpr double kWorthShare = 0.01;

bool isShortOfReach(const AccessibleArea& area) {
    return isHeldOff(area) || (area.excluded && area.excluded->reason == ExclusionReason::TooShort);
}

/// A drill of the hole's size, however long it is: others are turned down for their type.
Shallower depthOfDrill(const Feature& feature, const ToolAssembly& drill) {
    Shallower found;
    const double reach_mm =
        drill.flute_length_mm > 0 ? std::min(drill.flute_length_mm, drill.stick_out_mm) : drill.stick_out_mm;
    found.floor_z_mm = std::max(feature.floor_z_mm, feature.top_z_mm - reach_mm);
    found.volume_mm3 = feature.area_mm2 * (feature.top_z_mm - found.floor_z_mm);
    found.stick_out_mm = feature.depth_mm();
    return found;
}

Shallower depthOf(const FeatureGround& ground, const ToolAssembly& tool, const AccessibleArea& area) {
    const Feature& feature = ground.feature();
    Shallower found;
    if (tool.isDrill()) {
        found = depthOfDrill(feature, tool);
    } else {
        const Reach reach = reachOf(ground, tool, area);
        // Off the height where the holder would graze what stands.
        found.floor_z_mm = reach.floor_z_mm + ground.tolerances().linear_mm;
        found.volume_mm3 = area.coverable_area_mm2 * (feature.top_z_mm - found.floor_z_mm);
        found.stick_out_mm = reach.stick_out_mm;
    }
    found.diameter_mm = tool.diameter_mm;
    return found;
}

}  // namespace

bool isHeldOff(const AccessibleArea& area) {
    return area.excluded && area.excluded->reason == ExclusionReason::HolderCollision;
}

std::optional<Withheld> withheldFrom(const FeatureGround& ground, const ToolLibrary& library, double most_mm2,
                                     const std::vector<AccessibleArea>& areas) {
    const double same_mm2 = sameArea(ground.feature(), ground.tolerances());
    double widest_mm2 = most_mm2 + same_mm2;
    for (const AccessibleArea& area : areas)
        if (isHeldOff(area)) widest_mm2 = std::max(widest_mm2, area.coverable_area_mm2);
    const AccessibleArea* found = nullptr;
    double longer_mm = 0;
    Withheld withheld;
    for (const AccessibleArea& area : areas) {
        const bool reaches = area.coverable_area_mm2 >= widest_mm2 - same_mm2;
        if (!isHeldOff(area) || !reaches || area.coverable_area_mm2 <= most_mm2 + same_mm2) continue;
        const ToolAssembly& tool = library.tool(area.tool_id);
        const double stick_out_mm = reachOf(ground, tool, area).stick_out_mm;
        if (found != nullptr && stick_out_mm - tool.stick_out_mm >= longer_mm) continue;
        found = &area;
        longer_mm = stick_out_mm - tool.stick_out_mm;
        withheld.diameter_mm = tool.diameter_mm;
        withheld.stick_out_mm = stick_out_mm;
        withheld.has_stick_out_mm = tool.stick_out_mm;
    }
    if (found == nullptr) return std::nullopt;
    withheld.coverable = found->coverable;
    const double slim_mm = widestClearHolderMm(ground, library.tool(found->tool_id), *found);
    if (slim_mm > withheld.diameter_mm) withheld.holder_diameter_mm = slim_mm;
    return withheld;
}

void admitLimited(const FeatureGround& ground, const ToolLibrary& library, double most_mm2,
                  std::vector<AccessibleArea>& areas) {
    const double same_mm2 = sameArea(ground.feature(), ground.tolerances());
    tbb::parallel_for(std::size_t{0}, areas.size(), [&](std::size_t i) {
        if (!isHeldOff(areas[i]) || areas[i].collision_free_area_mm2 <= most_mm2 + same_mm2) return;
        auto limited = limitedArea(ground, library.tool(areas[i].tool_id), areas[i]);
        if (limited && limited->coverable_area_mm2 > most_mm2 + same_mm2) areas[i] = std::move(*limited);
    });
}

std::optional<Shallower> shallower(const FeatureGround& ground, const ToolLibrary& library,
                                   const std::vector<AccessibleArea>& areas, double known_mm3) {
    const Feature& feature = ground.feature();
    const double least_mm3 = known_mm3 + kWorthShare * feature.area_mm2 * feature.depth_mm();
    std::vector<std::optional<Shallower>> found(areas.size());
    tbb::parallel_for(std::size_t{0}, areas.size(), [&](std::size_t i) {
        if (!isShortOfReach(areas[i])) return;
        const ToolAssembly& tool = library.tool(areas[i].tool_id);
        const double area_mm2 = tool.isDrill() ? feature.area_mm2 : areas[i].coverable_area_mm2;
        if (area_mm2 * feature.depth_mm() > least_mm3) found[i] = depthOf(ground, tool, areas[i]);
    });
    std::optional<Shallower> best;
    for (const auto& candidate : found) {
        if (!candidate || candidate->volume_mm3 <= least_mm3) continue;
        // depthOf() keeps one `linear_mm` off what the holder would graze; that alone is no smaller depth.
        if (candidate->floor_z_mm <= feature.floor_z_mm + 2 * ground.tolerances().linear_mm) continue;
        if (!best || candidate->volume_mm3 > best->volume_mm3) best = candidate;
    }
    return best;
}

Feature withFloor(Feature feature, double floor_z_mm) {
    feature.floor_z_mm = floor_z_mm;
    feature.volume_mm3 = feature.area_mm2 * feature.depth_mm();
    if (feature.through) {
        feature.through = false;
        if (feature.feature_class == FeatureClass::HoleThrough)
            feature.feature_class = FeatureClass::HoleBlind;
    }
    return feature;
}

}  // namespace stepmill
