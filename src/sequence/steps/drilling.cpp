#include "stepmill/sequence/drilling.h"

#include <fmt/format.h>

#include "stepmill/core/units.h"

namespace stepmill {
namespace {

/// How far the full diameter of a drill leaves a through hole at the far side [mm].
constexpr double kBreakThroughMm = 0.5;
/// Half the point angle of a general-purpose (118 degree) drill.
constexpr double kHalfPointAngleDeg = 59;

double holeRadiusMm(const Feature& feature) {
    return std::sqrt(area(feature.target) / kPi);
}

double pointLengthMm(double drill_radius_mm) {
    return drill_radius_mm / std::tan(degToRad(kHalfPointAngleDeg));
}

double tipZ(const Feature& feature, double drill_radius_mm) {
    return feature.through ? feature.floor_z_mm - pointLengthMm(drill_radius_mm) - kBreakThroughMm
                           : feature.floor_z_mm;
}

/// Does a cylinder around the hole's axis meet what stands over its bottom?
bool meetsObstacle(const Feature& feature, const Vec2& axis, double bottom_z_mm, double radius_mm) {
    for (const Obstacle& obstacle : feature.obstacles) {
        if (obstacle.top_z_mm <= bottom_z_mm || obstacle.section.empty()) continue;
        if (contains(obstacle.section, axis) || distanceToBoundary(obstacle.section, axis) < radius_mm)
            return true;
    }
    return false;
}

std::optional<Exclusion> shankOrHolderCollision(const Feature& feature, const ToolAssembly& drill) {
    std::vector<HolderCylinder> cylinders;
    if (drill.shank.diameter_mm > drill.diameter_mm) cylinders.push_back(drill.shank);
    cylinders.insert(cylinders.end(), drill.holder.begin(), drill.holder.end());
    const Vec2 axis = centroid(feature.target);
    const double tip_z = drillTipZ(feature, drill);
    for (const HolderCylinder& cylinder : cylinders) {
        if (!meetsObstacle(feature, axis, tip_z + cylinder.bottom_mm, cylinder.diameter_mm / 2)) continue;
        return Exclusion{ExclusionReason::HolderCollision,
                         fmt::format("its {:g} mm wide holder would touch {:g} mm over the tip",
                                     cylinder.diameter_mm, cylinder.bottom_mm)};
    }
    return std::nullopt;
}

}  // namespace

double pointLengthMm(const ToolAssembly& drill) {
    return pointLengthMm(drill.radius_mm());
}

double drillTipZ(const Feature& feature, const ToolAssembly& drill) {
    return tipZ(feature, drill.radius_mm());
}

double deepestDrillTipZ(const Feature& feature) {
    return tipZ(feature, holeRadiusMm(feature));
}

DrillCheck drillCheck(const Feature& feature, const ToolAssembly& drill, const Tolerances& tol) {
    DrillCheck result;
    if (!drill.isDrill() || !isHole(feature.feature_class)) return result;
    const double hole_mm = 2 * holeRadiusMm(feature);
    const bool matches =
        drill.diameter_mm <= hole_mm + 2 * tol.gouge_mm && drill.diameter_mm >= hole_mm - kDrillUndersizeMm;
    if (!matches) return result;
    const double needed = feature.top_z_mm - drillTipZ(feature, drill);
    const double reach =
        drill.flute_length_mm > 0 ? std::min(drill.flute_length_mm, drill.stick_out_mm) : drill.stick_out_mm;
    if (reach < needed) {
        result.excluded =
            Exclusion{ExclusionReason::TooShort,
                      fmt::format("reaches {:.4g} mm, the hole needs {:.4g} mm", reach, needed)};
    } else {
        result.excluded = shankOrHolderCollision(feature, drill);
    }
    result.fits = !result.excluded;
    return result;
}

SequenceStep drillStep(const Feature& feature, const ToolAssembly& drill, const CuttingData& cutting,
                       double retract_z_mm, const Machine& machine) {
    SequenceStep step;
    step.tool_id = drill.id;
    step.role = Role::Drill;
    step.speed_rpm = cutting.speed_rpm;
    step.area.area = feature.target;
    step.area.new_area_mm2 = feature.area_mm2;
    step.path = drillHole(centroid(feature.target), feature.top_z_mm, drillTipZ(feature, drill), retract_z_mm,
                          drill, cutting, machine);
    // The axis stays on the hole's axis, so the wall is everywhere equally far.
    step.proof.least_clearance_mm = holeRadiusMm(feature) - drill.radius_mm();
    return step;
}

}  // namespace stepmill
