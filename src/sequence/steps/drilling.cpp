#include "stepmill/sequence/drilling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "sequence/steps/hole_room.h"
#include "stepmill/core/units.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/toolpath/swept_region.h"

namespace stepmill {
namespace {

double pointLengthMm(double drill_radius_mm, double point_angle_deg) {
    return drill_radius_mm / std::tan(degToRad(point_angle_deg / 2));
}

/// The tip as deep as the drill's cone stays inside the part's: neither tip nor rim comes through.
double tipInPointZ(const Feature& hole, const ToolAssembly& drill) {
    const double hole_mm = std::max(holeRadiusMm(hole), drill.radius_mm());
    const double beside_mm = (hole_mm - drill.radius_mm()) * hole.point_mm / hole_mm;
    const double by_rim_z = hole.floor_z_mm - beside_mm - pointLengthMm(drill);
    return std::max(hole.floor_z_mm - hole.point_mm, by_rim_z);
}

std::optional<Exclusion> shankOrHolderCollision(const Feature& feature, const ToolAssembly& drill,
                                                double tip_z) {
    std::vector<HolderCylinder> cylinders = keptOffHolder(drill);
    if (drill.shank.diameter_mm > drill.diameter_mm) cylinders.insert(cylinders.begin(), drill.shank);
    const std::vector<Vec2> axes = holeCentres(feature);
    for (const HolderCylinder& cylinder : cylinders) {
        const bool meets = std::any_of(axes.begin(), axes.end(), [&](const Vec2& axis) {
            return meetsObstacle(feature, axis, tip_z + cylinder.bottom_mm, cylinder.diameter_mm / 2);
        });
        if (!meets) continue;
        return Exclusion{ExclusionReason::HolderCollision,
                         fmt::format("its {:g} mm wide holder would touch {:g} mm over the tip{}",
                                     cylinder.diameter_mm, cylinder.bottom_mm, clearanceWords(drill))};
    }
    return std::nullopt;
}

/// What a drill with no longer flutes comes out by below a through hole, at its full width [mm].
constexpr double kLeastBreakThroughMm = 0.1;

/// Where the tip is with the flutes wholly in the hole; no limit where the library does not have their
/// length.
double tipByFlutesZ(const Feature& hole, const ToolAssembly& drill) {
    return drill.flute_length_mm > 0 ? hole.top_z_mm - drill.flute_length_mm
                                     : -std::numeric_limits<double>::infinity();
}

/// The tip of a drill that makes room stays so far over the floor [mm].
constexpr double kOverFloorMm = 0.1;

/// Not where something stands in the hole.
bool goesIn(const Feature& hole, const ToolAssembly& drill, const Tolerances& tol) {
    return isFullCircles(hole.target) && drill.diameter_mm <= 2 * holeRadiusMm(hole) + 2 * tol.gouge_mm;
}

bool isFlat(const Feature& hole) {
    return !hole.through && hole.point_mm <= 0;
}

/// Too short for the hole, or shank or holder in the way; nothing where it gets down.
std::optional<Exclusion> keptFrom(const Feature& feature, const ToolAssembly& drill, double tip_z_mm) {
    const double needed = feature.top_z_mm - tip_z_mm;
    const double reach = drillReachMm(drill);
    if (reach < needed)
        return Exclusion{ExclusionReason::TooShort,
                         fmt::format("reaches {:.4g} mm, the hole needs {:.4g} mm", reach, needed)};
    return shankOrHolderCollision(feature, drill, tip_z_mm);
}

double preDrilledTipZ(const Feature& feature, const ToolAssembly& drill) {
    if (feature.through && preDrilledToZ(feature, drill) <= feature.floor_z_mm)
        return drillTipZ(feature, drill);
    return preDrilledToZ(feature, drill) - pointLengthMm(drill);
}

/// Every hole of the feature drilled to that depth.
SequenceStep stepTo(double tip_z_mm, const Feature& feature, const ToolAssembly& drill,
                    const CuttingData& cutting, double retract_z_mm, const Machine& machine) {
    SequenceStep step;
    step.tool_id = drill.id;
    step.role = Role::Drill;
    step.speed_rpm = cutting.speed_rpm;
    const std::vector<Vec2> centres = holeCentres(feature);
    step.holes = static_cast<int>(centres.size());
    step.path =
        drillHoles(shortestTour(centres), feature.top_z_mm, tip_z_mm, retract_z_mm, drill, cutting, machine);
    // The axis stays on the hole's axis, so the wall is everywhere equally far.
    step.proof.least_clearance_mm = holeRadiusMm(feature) - drill.radius_mm();
    return step;
}

/// What the drill's cone takes below the floor of one hole [mm3].
double takenBelowMm3(const Feature& hole, const ToolAssembly& drill) {
    const double deep_mm = hole.floor_z_mm - drillTipZ(hole, drill);
    if (hole.through || hole.point_mm <= 0 || deep_mm <= 0) return 0;
    const double wide_mm = std::min(drill.radius_mm(), drill.radius_mm() * deep_mm / pointLengthMm(drill));
    return kPi * wide_mm * wide_mm * deep_mm / 3;
}

}  // namespace

bool isOfSize(const Feature& hole, const ToolAssembly& drill, const Tolerances& tol) {
    if (!goesIn(hole, drill, tol)) return false;
    if (hole.drilled) return hole.drilled->holds(drill.diameter_mm);
    return drill.diameter_mm >= 2 * holeRadiusMm(hole) - kDrillUndersizeMm;
}

std::optional<double> widthThatMeets(const Feature& hole, const ToolAssembly& tool,
                                     const HolderCylinder& cutter, double tip_z_mm) {
    std::vector<HolderCylinder> cylinders = keptOffHolder(tool);
    cylinders.insert(cylinders.begin(), {cutter, tool.shank});
    const std::vector<Vec2> axes = holeCentres(hole);
    for (const HolderCylinder& cylinder : cylinders) {
        const double bottom_z_mm = std::max(tip_z_mm + cylinder.bottom_mm, hole.top_z_mm);
        for (const Vec2& axis : axes)
            if (meetsObstacle(hole, axis, bottom_z_mm, cylinder.diameter_mm / 2)) return cylinder.diameter_mm;
    }
    return std::nullopt;
}

std::string troubleBeside(const Feature& hole, const ToolAssembly& tool, double tip_z_mm) {
    const auto width_mm = widthThatMeets(hole, tool, {tool.diameter_mm, 0, tool.flute_length_mm}, tip_z_mm);
    if (!width_mm) return {};
    return fmt::format("{} would touch what stands beside the hole, {:g} mm wide{}", tool.id, *width_mm,
                       clearanceWords(tool));
}

bool meetsObstacle(const Feature& feature, const Vec2& axis, double bottom_z_mm, double radius_mm) {
    for (const Obstacle& obstacle : feature.obstacles) {
        if (obstacle.top_z_mm <= bottom_z_mm || obstacle.section.empty()) continue;
        if (contains(obstacle.section, axis) || distanceToBoundary(obstacle.section, axis) < radius_mm)
            return true;
    }
    return false;
}

double pointLengthMm(const ToolAssembly& drill) {
    return pointLengthMm(drill.radius_mm(), drill.point_angle_deg);
}

double drillReachMm(const ToolAssembly& drill) {
    return drill.flute_length_mm > 0 ? std::min(drill.flute_length_mm, drill.stick_out_mm)
                                     : drill.stick_out_mm;
}

double drillTipZ(const Feature& feature, const ToolAssembly& drill) {
    if (feature.through) {
        const double just_through_z = feature.floor_z_mm - pointLengthMm(drill);
        return std::clamp(tipByFlutesZ(feature, drill), just_through_z - kBreakThroughMm,
                          just_through_z - kLeastBreakThroughMm);
    }
    return feature.point_mm > 0 ? tipInPointZ(feature, drill) : feature.floor_z_mm;
}

double deepestDrillTipZ(const Feature& feature) {
    return feature.floor_z_mm - outOfHoleMm(holeRadiusMm(feature));
}

double drilledToZ(const Feature& feature, const ToolAssembly& drill) {
    const double shoulder_z = drillTipZ(feature, drill) + pointLengthMm(drill);
    const bool fits =
        feature.point_mm > 0 && shoulder_z <= feature.floor_z_mm + kPointFitShare * drill.radius_mm();
    return fits ? std::min(shoulder_z, feature.floor_z_mm) : shoulder_z;
}

double leftByPointMm3(const Feature& feature, const ToolAssembly& drill) {
    const double over_mm = std::min(drilledToZ(feature, drill) - feature.floor_z_mm, feature.depth_mm());
    if (over_mm <= 0) return 0;
    // The cone over the floor from where it leaves it out to the rim: cylinder less frustum.
    const double point_mm = pointLengthMm(drill);
    const double inner = 1 - over_mm / point_mm;
    const double frustum_share = (1 + inner + inner * inner) / 3;
    return feature.area_mm2 * over_mm * (1 - frustum_share);
}

DrillCheck drillCheck(const Feature& feature, const ToolAssembly& drill, const Tolerances& tol) {
    DrillCheck result;
    if (!drill.isDrill() || !isHole(feature.feature_class)) return result;
    if (!isOfSize(feature, drill, tol)) return result;
    result.excluded = keptFrom(feature, drill, drillTipZ(feature, drill));
    result.fits = !result.excluded;
    return result;
}

SequenceStep drillStep(const Feature& feature, const ToolAssembly& drill, const CuttingData& cutting,
                       double retract_z_mm, const Machine& machine) {
    SequenceStep step = stepTo(drillTipZ(feature, drill), feature, drill, cutting, retract_z_mm, machine);
    step.area.area = feature.target;
    step.area.new_area_mm2 = feature.area_mm2;
    if (const double taken_mm3 = takenBelowMm3(feature, drill) * step.holes; taken_mm3 > 0)
        step.takes = {{{Reason::DrillPoint, {}}, taken_mm3}};
    return step;
}

bool preDrills(const Feature& feature, const ToolAssembly& drill, const Tolerances& tol) {
    if (!drill.isDrill() || !isHole(feature.feature_class) || !goesIn(feature, drill, tol)) return false;
    if (isOfSize(feature, drill, tol) && !isFlat(feature) &&
        !keptFrom(feature, drill, drillTipZ(feature, drill)))
        return false;
    return preDrilledToZ(feature, drill) < feature.top_z_mm &&
           !keptFrom(feature, drill, preDrilledTipZ(feature, drill));
}

CutterArea preDrilledArea(const Feature& feature, const ToolAssembly& drill, const Tolerances& tol) {
    CutterArea area;
    area.radius_mm = drill.radius_mm();
    for (const Vec2& centre : holeCentres(feature)) {
        const Region disc = makeCircle(centre, std::min(drill.radius_mm(), holeRadiusMm(feature)));
        append(area.coverable, disc);
    }
    area.accessible = area.coverable;
    area.coverable_area_mm2 = stepmill::area(area.coverable);
    area.access_volume_mm3 = area.coverable_area_mm2 * feature.depth_mm();
    // A mill as wide as the drill comes down in the hole too: skins are nothing to it.
    area.swept = SureSweep(offset(area.coverable, toolpath::kSkinSlivers * tol.sliver_mm, tol), tol);
    return area;
}

double preDrilledToZ(const Feature& feature, const ToolAssembly& drill) {
    const double by_flutes_z = tipByFlutesZ(feature, drill);
    if (feature.through && by_flutes_z <= drillTipZ(feature, drill)) return feature.floor_z_mm;
    return std::max(feature.floor_z_mm + kOverFloorMm, by_flutes_z) + pointLengthMm(drill);
}

SequenceStep preDrillStep(const Feature& feature, const ToolAssembly& drill, const CuttingData& cutting,
                          double retract_z_mm, const Machine& machine, const Tolerances& tol) {
    const double to_z_mm = preDrilledToZ(feature, drill);
    SequenceStep step =
        stepTo(preDrilledTipZ(feature, drill), feature, drill, cutting, retract_z_mm, machine);
    step.area.area = preDrilledArea(feature, drill, tol).coverable;
    step.area.new_area_mm2 = area(step.area.area);
    step.leaves.floors_mm = to_z_mm - feature.floor_z_mm;
    return step;
}

}  // namespace stepmill
