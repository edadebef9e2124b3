#include "sequence/holder/holder_limits.h"

#include <algorithm>

#include "sequence/dag/candidate.h"
#include "stepmill/access/lumps.h"
#include "stepmill/core/parallel.h"
#include "stepmill/sequence/drilling.h"

namespace stepmill {
namespace {

/// Going less deep must machine this much more of the feature to be worth it.
constexpr double kWorthShare = 0.01;

/// Of what a longer tool would clear in addition a wider one's part is as much.
constexpr double kMostShare = 0.9;

/// A drill whose tip gets down to a hole's end, but not its full width, stops so far above it [mm].
constexpr double kLeftUnderDrillMm = 0.5;

bool isExcludedFor(const ToolReach& reach, ExclusionReason reason) {
    const Exclusion* excluded = reach.exclusion();
    return excluded != nullptr && excluded->reason == reason;
}

bool isShortOfReach(const ToolReach& reach) {
    return isHeldOff(reach) || isExcludedFor(reach, ExclusionReason::TooShort);
}

/// Does a drill that may yet make room for a mill not make the hole itself, as it is too short?
bool isShortDrill(const FeatureGround& ground, const ToolAssembly& tool) {
    if (!tool.isDrill()) return false;
    const DrillCheck check = drillCheck(ground.feature(), tool, ground.tolerances());
    return check.excluded && check.excluded->reason == ExclusionReason::TooShort;
}

/// A drill of the hole's size, however long it is: others are turned down for their type.
Shallower depthOfDrill(const Feature& feature, const ToolAssembly& drill) {
    Shallower found;
    const double reach_mm = drillReachMm(drill);
    found.by_flutes = reach_mm < drill.stick_out_mm;
    found.floor_z_mm = std::max(feature.floor_z_mm + kLeftUnderDrillMm, feature.top_z_mm - reach_mm);
    found.volume_mm3 = feature.area_mm2 * (feature.top_z_mm - found.floor_z_mm);
    ToolAssembly longer = drill;
    longer.flute_length_mm = 0;
    found.stick_out_mm = feature.top_z_mm - drillTipZ(feature, longer);
    return found;
}

Shallower depthOf(const FeatureGround& ground, const ToolAssembly& tool, const CutterArea& area) {
    const Feature& feature = ground.feature();
    Shallower found;
    if (tool.isDrill()) {
        found = depthOfDrill(feature, tool);
    } else {
        const DepthLimit limit = depthLimitOf(ground, tool, area);
        // Off the height where the holder would graze what stands.
        found.floor_z_mm = limit.floor_z_mm + ground.tolerances().linear_mm;
        found.volume_mm3 = area.coverable_area_mm2 * (feature.top_z_mm - found.floor_z_mm);
        found.stick_out_mm = limit.stick_out_mm;
    }
    found.diameter_mm = tool.diameter_mm;
    found.has_stick_out_mm = tool.stick_out_mm;
    return found;
}

}  // namespace

bool isHeldOff(const ToolReach& reach) {
    return isExcludedFor(reach, ExclusionReason::HolderCollision);
}

std::optional<Withheld> withheldFrom(const FeatureGround& ground, const ToolLibrary& library, double most_mm2,
                                     const std::vector<ToolReach>& reaches) {
    const double same_mm2 = sameArea(ground.feature(), ground.tolerances());
    double widest_mm2 = most_mm2;
    for (const ToolReach& reach : reaches)
        if (isShortOfReach(reach)) widest_mm2 = std::max(widest_mm2, reach.cutter.coverable_area_mm2);
    const double enough_mm2 = std::max(most_mm2 + same_mm2, most_mm2 + kMostShare * (widest_mm2 - most_mm2));
    const ToolReach* found = nullptr;
    double longer_mm = 0;
    Withheld withheld;
    for (const ToolReach& reach : reaches) {
        if (!isShortOfReach(reach) || reach.cutter.coverable_area_mm2 <= enough_mm2) continue;
        const ToolAssembly& tool = library.tool(reach.tool_id);
        const double stick_out_mm = depthLimitOf(ground, tool, reach.cutter).stick_out_mm;
        if (found != nullptr && stick_out_mm - tool.stick_out_mm >= longer_mm) continue;
        found = &reach;
        longer_mm = stick_out_mm - tool.stick_out_mm;
        withheld.diameter_mm = tool.diameter_mm;
        withheld.stick_out_mm = stick_out_mm;
        withheld.has_stick_out_mm = tool.stick_out_mm;
    }
    if (found == nullptr) return std::nullopt;
    withheld.too_short = !isHeldOff(*found);
    withheld.coverable = found->cutter.coverable;
    const double slim_mm = widestClearHolderMm(ground, library.tool(found->tool_id), found->cutter);
    if (!withheld.too_short && slim_mm > withheld.diameter_mm) withheld.holder_diameter_mm = slim_mm;
    return withheld;
}

std::optional<Shallower> shallower(const FeatureGround& ground, const ToolLibrary& library,
                                   const std::vector<ToolReach>& reaches, double known_mm3) {
    const Feature& feature = ground.feature();
    const double least_mm3 = known_mm3 + kWorthShare * feature.area_mm2 * feature.depth_mm();
    std::vector<std::optional<Shallower>> found(reaches.size());
    parallelFor(reaches.size(), [&](std::size_t i) {
        const ToolAssembly& tool = library.tool(reaches[i].tool_id);
        if (!isShortOfReach(reaches[i]) && !isShortDrill(ground, tool)) return;
        const CutterArea& cutter = reaches[i].cutter;
        const double area_mm2 = tool.isDrill() ? feature.area_mm2 : cutter.coverable_area_mm2;
        if (area_mm2 * feature.depth_mm() > least_mm3) found[i] = depthOf(ground, tool, cutter);
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
    feature.point_mm = 0;
    if (feature.through) {
        feature.through = false;
        if (feature.feature_class == FeatureClass::HoleThrough)
            feature.feature_class = FeatureClass::HoleBlind;
    }
    return feature;
}

}  // namespace stepmill
