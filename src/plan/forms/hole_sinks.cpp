// Cones that a countersink makes in one stroke.

#include "plan/forms/hole_sinks.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>

#include "stepmill/catalog/cutter_form.h"
#include "stepmill/feature/heights.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/unsure_offset.h"

namespace stepmill {
namespace {

/// A tool that is narrower than a cone by less makes it whole [mm].
constexpr double kAsWideMm = 0.02;
/// Tip heights are whole steps of this, so that equal sinks are one cycle [mm].
constexpr double kTipStepMm = 1e-3;
/// The axis has so much room on all sides where the tip is as deep as it goes [mm].
constexpr double kSinkRoomMm = 0.003;
/// Where that is not enough (sections are polygons across curved walls) the tip stays higher, so often by so
/// much [mm].
constexpr int kHigherTries = 4;
constexpr double kHigherMm = 0.01;

/// Is it a cone of the tool's angle, no wider than the tool and wider at its foot than the tool's tip?
bool fits(const HoleCone& cone, const ToolAssembly& tool) {
    return std::abs(cone.lean - flankLean(tool)) <= kSameLean &&
           cone.radius_mm <= tool.radius_mm() + kAsWideMm && tool.tip_diameter_mm / 2 < cone.foot_radius_mm;
}

/// As deep as the tip may go on the axis: a band's section is the part at its foot, the tool counts with its
/// radius at the band's top.
double deepestTipMm(const FormSite& site, const HoleCone& cone, const ToolAssembly& tool,
                    const Tolerances& tol) {
    const double tool_slope = flankLean(tool) / std::sqrt(1 - flankLean(tool) * flankLean(tool));
    const double tip_radius_mm = tool.tip_diameter_mm / 2;
    double tip_mm = -std::numeric_limits<double>::infinity();
    for (const Obstacle& band : site.ground.must_stand) {
        if (band.bottom_z_mm >= cone.top_z_mm - kSameHeightMm ||
            band.top_z_mm <= cone.bottom_z_mm + kSameHeightMm)
            continue;
        const double foot_mm = std::max(band.bottom_z_mm, cone.bottom_z_mm);
        const double room_mm = cone.radius_mm - (cone.top_z_mm - foot_mm) * cone.slope() - tol.guard_mm -
                               kSinkRoomMm - tip_radius_mm;
        tip_mm = std::max(tip_mm, std::min(band.top_z_mm, cone.top_z_mm) - room_mm / tool_slope);
    }
    return std::ceil(tip_mm / kTipStepMm) * kTipStepMm;
}

std::optional<double> freeTipMm(const FormSite& site, const HoleCone& cone, const ToolAssembly& tool,
                                const FormCentres& centres, const Tolerances& tol) {
    double tip_mm = deepestTipMm(site, cone, tool, tol);
    for (int i = 0; i < kHigherTries && tip_mm < cone.top_z_mm; ++i, tip_mm += kHigherMm) {
        try {
            if (contains(centres.at(tip_mm), cone.centre)) return tip_mm;
        } catch (const UnsureOffset&) {
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<toolpath::FormLevel> sinkLevels(const FormSite& site, const ToolAssembly& tool,
                                            const FormCentres& centres, const Tolerances& tol) {
    std::map<double, std::vector<Path>, std::greater<>> places;
    for (const HoleCone& cone : site.cones)
        if (fits(cone, tool))
            if (const auto tip_mm = freeTipMm(site, cone, tool, centres, tol))
                places[*tip_mm].push_back({cone.centre, {}});
    std::vector<toolpath::FormLevel> levels;
    levels.reserve(places.size());
    for (auto& [tip_mm, passes] : places)
        levels.push_back({tip_mm, centres.at(tip_mm), std::move(passes)});
    return levels;
}

}  // namespace stepmill
