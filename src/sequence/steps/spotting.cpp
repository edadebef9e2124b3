#include "stepmill/sequence/spotting.h"

#include <algorithm>
#include <cmath>

#include "sequence/steps/hole_room.h"
#include "stepmill/core/units.h"
#include "stepmill/feature/hole_group.h"

namespace stepmill {
namespace {

double halfAngleRad(const ToolAssembly& spot) {
    return degToRad(spot.point_angle_deg) / 2;
}

}  // namespace

double spotTipZ(const Feature& feature, const ToolAssembly& spot) {
    const double widest_mm = std::min(holeRadiusMm(feature), spot.radius_mm());
    return feature.top_z_mm - kSpotShare * widest_mm / std::tan(halfAngleRad(spot));
}

double spotRadiusMm(const Feature& feature, const ToolAssembly& spot, double tip_z_mm) {
    return std::min(spot.radius_mm(), (feature.top_z_mm - tip_z_mm) * std::tan(halfAngleRad(spot)));
}

bool spotFits(const Feature& feature, const ToolAssembly& spot) {
    if (!isHole(feature.feature_class) || !isFullCircles(feature.target)) return false;
    const double tip_z_mm = spotTipZ(feature, spot);
    if (tip_z_mm < feature.floor_z_mm) return false;
    // In the hole it is a cone; what stands over the hole meets its whole width.
    return !widthThatMeets(feature, spot, {spot.diameter_mm, 0, spot.stick_out_mm}, tip_z_mm);
}

SequenceStep spotStep(const Feature& feature, const ToolAssembly& spot, const CuttingData& cutting,
                      double retract_z_mm, const Machine& machine) {
    const double tip_z_mm = spotTipZ(feature, spot);
    const std::vector<Vec2> centres = holeCentres(feature);
    SequenceStep step;
    step.tool_id = spot.id;
    step.role = Role::Spot;
    step.speed_rpm = cutting.speed_rpm;
    step.holes = static_cast<int>(centres.size());
    step.path =
        drillHoles(shortestTour(centres), feature.top_z_mm, tip_z_mm, retract_z_mm, spot, cutting, machine);
    step.proof.least_clearance_mm = holeRadiusMm(feature) - spotRadiusMm(feature, spot, tip_z_mm);
    step.leaves.floors_mm = tip_z_mm - feature.floor_z_mm;
    return step;
}

}  // namespace stepmill
