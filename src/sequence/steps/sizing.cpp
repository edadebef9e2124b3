#include "stepmill/sequence/sizing.h"

#include <algorithm>

#include <fmt/format.h>

#include "sequence/steps/hole_room.h"
#include "stepmill/access/access.h"
#include "stepmill/core/units.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/sequence/drilling.h"

namespace stepmill {
namespace {

/// What a reamer takes off the diameter: less rubs, more tears [mm].
constexpr double kLeastReamedMm = 0.05;
constexpr double kMostReamedMm = 0.15;
/// And so much more of the diameter.
constexpr double kMostReamedShare = 0.015;
/// What a boring head takes off the diameter [mm].
constexpr double kLeastBoredMm = 0.1;
constexpr double kMostBoredMm = 1.0;
/// How far the whole width leaves a through hole at the far side [mm].
constexpr double kBeyondMm = 0.5;
/// Diameters of tools are measured to a tenth of a micrometre at best [mm].
constexpr double kMeasuredMm = 1e-4;

std::string offLimits(const SizingTask& task, const ToolAssembly& sizer) {
    const double nominal_mm = 2 * holeRadiusMm(task.hole);
    const auto limits = boreLimits(task.fit, nominal_mm);
    if (!limits) return fmt::format("no limits are known for a bore of {:.4g} mm", nominal_mm);
    const bool within = sizer.diameter_mm >= limits->least_mm - kMeasuredMm &&
                        sizer.diameter_mm <= limits->most_mm + kMeasuredMm;
    if (within) return {};
    return fmt::format("{} is {:.4f} mm wide, {} of {:.4g} mm is {:.4f} to {:.4f} mm", sizer.id,
                       sizer.diameter_mm, task.fit.name, nominal_mm, limits->least_mm, limits->most_mm);
}

}  // namespace

DiameterRange boreBefore(const ToolAssembly& sizer, double bore_mm) {
    if (sizer.type == ToolType::Boring) return {bore_mm - kMostBoredMm, bore_mm - kLeastBoredMm};
    return {bore_mm - kMostReamedMm - kMostReamedShare * bore_mm, bore_mm - kLeastReamedMm};
}

bool isSizedBy(Role role, const std::optional<Fit>& fit, const HoleEntry& entry) {
    if (role == Role::Finish) return entry.make == HoleMaking::Bore;
    return fit && fit->name == entry.fit->name;
}

double sizedToZ(const Feature& hole, const ToolAssembly& sizer, double bored_to_z_mm) {
    return hole.through ? hole.floor_z_mm : std::max(bored_to_z_mm, hole.floor_z_mm) + sizer.lead_mm;
}

double sizerTipZ(const Feature& hole, const ToolAssembly& sizer, double sized_to_z_mm) {
    return sized_to_z_mm - sizer.lead_mm - (hole.through ? kBeyondMm : 0);
}

std::string sizingTrouble(const SizingTask& task, const ToolAssembly& sizer) {
    const Feature& hole = task.hole;
    if (std::string off = offLimits(task, sizer); !off.empty()) return off;
    const double sized_to_z_mm = sizedToZ(hole, sizer, task.bored_to_z_mm);
    const double tip_z_mm = sizerTipZ(hole, sizer, sized_to_z_mm);
    if (sized_to_z_mm >= hole.top_z_mm || tip_z_mm < deepestDrillTipZ(hole))
        return fmt::format("the lead of {} is too long for the hole", sizer.id);
    const bool slim = sizer.shank.diameter_mm < 2 * holeRadiusMm(hole);
    const double reach_mm = slim ? sizer.stick_out_mm : sizer.flute_length_mm;
    if (hole.top_z_mm - tip_z_mm > reach_mm)
        return fmt::format("{} reaches {:.4g} mm, its tip must go {:.4g} mm deep", sizer.id, reach_mm,
                           hole.top_z_mm - tip_z_mm);
    return troubleBeside(hole, sizer, tip_z_mm);
}

double leftByLeadMm3(const SizingTask& task, const ToolAssembly& sizer, double before_mm) {
    const Feature& hole = task.hole;
    const double over_mm = sizedToZ(hole, sizer, task.bored_to_z_mm) - hole.floor_z_mm;
    const double share = before_mm / (2 * holeRadiusMm(hole));
    return hole.through ? 0 : hole.area_mm2 * (1 - share * share) * over_mm;
}

SequenceStep sizingStep(const SizingTask& task, const ToolAssembly& sizer, const CuttingData& cutting,
                        const Machine& machine) {
    const Feature& hole = task.hole;
    const double sized_to_z_mm = sizedToZ(hole, sizer, task.bored_to_z_mm);
    const std::vector<Vec2> centres = holeCentres(hole);
    SequenceStep step;
    step.tool_id = sizer.id;
    step.role = sizer.type == ToolType::Boring ? Role::Bore : Role::Ream;
    step.speed_rpm = cutting.speed_rpm;
    step.holes = static_cast<int>(centres.size());
    step.fit = task.fit;
    step.leaves.floors_mm = sized_to_z_mm - hole.floor_z_mm;
    step.path = sizeHoles(shortestTour(centres), hole.top_z_mm, sizerTipZ(hole, sizer, sized_to_z_mm),
                          task.retract_z_mm, sizer, cutting, machine);
    step.area.area = hole.target;
    step.area.new_area_mm2 = 0;
    step.least_stick_out_mm = leastStickOutMm(
        sizer, [&](const ToolAssembly& shorter) { return sizingTrouble(task, shorter).empty(); });
    return step;
}

}  // namespace stepmill
