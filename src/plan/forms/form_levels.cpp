// At which heights a form cutter goes along the walls.

#include "plan/forms/form_levels.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "plan/forms/form_stairs.h"
#include "stepmill/catalog/cutter_form.h"
#include "stepmill/feature/heights.h"

namespace stepmill {
namespace {

/// The tip goes so far below the chamfer it makes, then, where that has no room, to its foot [mm].
constexpr double kBelowChamferMm[] = {0.5, 0.0};

/// How far the next level may be where a wall is touched with the tip at some height.
struct Demand {
    double tip_z_mm = 0;
    double step_mm = 0;
};

std::vector<Demand> demandsOf(const FormSite& site, double corner_mm, double scallop_mm) {
    const double along_mm = alongWallMm(corner_mm, scallop_mm);
    std::vector<Demand> demands;
    for (std::size_t i = 0; i < site.leans.size(); ++i) {
        const Obstacle& band = site.ground.must_stand[i];
        const double middle_mm = (band.bottom_z_mm + band.top_z_mm) / 2;
        for (const double lean : site.leans[i])
            demands.push_back(
                {middle_mm - corner_mm * (1 - lean),
                 std::max(kLeastLevelStepMm, along_mm * std::sqrt(std::max(0.0, 1 - lean * lean)))});
    }
    return demands;
}

/// The nearest end of a band, not above `under_mm`.
double onBand(const FormSite& site, double z_mm, double under_mm) {
    double best_mm = site.ground.must_stand.front().bottom_z_mm;
    for (const Obstacle& band : site.ground.must_stand)
        for (const double end_mm : {band.bottom_z_mm, band.top_z_mm})
            if (end_mm < under_mm - kSameHeightMm && std::abs(end_mm - z_mm) < std::abs(best_mm - z_mm))
                best_mm = end_mm;
    return best_mm;
}

/// How far below `z_mm` the next level may be: down to the first wall that is touched below, or nearer.
double stepBelow(const std::vector<Demand>& demands, double z_mm, double most_mm) {
    double step_mm = most_mm;
    for (const Demand& demand : demands)
        if (demand.tip_z_mm <= z_mm)
            step_mm = std::min(step_mm, std::max(demand.step_mm, z_mm - demand.tip_z_mm));
    return step_mm;
}

bool hasStairs(const FormSite& site, double bottom_mm, double top_mm) {
    return std::any_of(site.ground.stairs.begin(), site.ground.stairs.end(), [&](const Obstacle& stair) {
        return stair.bottom_z_mm < top_mm && stair.top_z_mm > bottom_mm;
    });
}

std::vector<double> wallLevels(const FormSite& site, double corner_mm, double step_down_mm,
                               double scallop_mm) {
    const std::vector<Demand> demands = demandsOf(site, corner_mm, scallop_mm);
    const double most_mm =
        std::min(alongWallMm(corner_mm, scallop_mm),
                 step_down_mm > 0 ? step_down_mm : std::numeric_limits<double>::infinity());
    const double lowest_mm = std::max(site.ground.must_stand.front().bottom_z_mm,
                                      site.ground.stairs.front().bottom_z_mm - corner_mm);
    std::vector<double> levels;
    double z_mm = site.ground.stairs.back().top_z_mm;
    while (z_mm > lowest_mm + kSameHeightMm) {
        double next_mm = std::max(lowest_mm, upOnHeightStep(z_mm - stepBelow(demands, z_mm, most_mm)));
        // The foot of a stair is a floor: there the corner makes the fillet.
        for (const double foot_mm : site.feet_mm)
            if (foot_mm < z_mm - kSameHeightMm && foot_mm > next_mm) next_mm = foot_mm;
        z_mm = next_mm;
        if (hasStairs(site, z_mm, z_mm + corner_mm + most_mm)) levels.push_back(z_mm);
    }
    return levels;
}

struct Chamfer {
    double bottom_mm = 0;
    double top_mm = 0;
};

/// Each stretch of bands with walls that lean like the flank, from above.
std::vector<Chamfer> chamfersOf(const FormSite& site, double lean) {
    std::vector<Chamfer> chamfers;
    bool goes_on = false;
    for (std::size_t i = 0; i < site.leans.size(); ++i) {
        const Obstacle& band = site.ground.must_stand[i];
        const bool fits = std::any_of(site.leans[i].begin(), site.leans[i].end(),
                                      [&](double other) { return std::abs(other - lean) <= kSameLean; });
        if (fits && !goes_on) chamfers.push_back({band.bottom_z_mm, band.top_z_mm});
        if (fits) chamfers.back().top_mm = band.top_z_mm;
        goes_on = fits;
    }
    std::reverse(chamfers.begin(), chamfers.end());
    return chamfers;
}

std::vector<double> chamferLevels(const FormSite& site, const ToolAssembly& tool) {
    const std::vector<Chamfer> chamfers = chamfersOf(site, flankLean(tool));
    const double cone_mm = CutterForm(tool).heightMm();
    const double lowest_mm = site.ground.must_stand.front().bottom_z_mm;
    std::vector<double> levels;
    for (const double below_mm : kBelowChamferMm) {
        for (const Chamfer& chamfer : chamfers) {
            if (chamfer.top_mm - chamfer.bottom_mm + below_mm > cone_mm) continue;
            const double level_mm =
                std::max(lowest_mm, onBand(site, chamfer.bottom_mm - below_mm, chamfer.top_mm));
            if (std::find(levels.begin(), levels.end(), level_mm) == levels.end()) levels.push_back(level_mm);
        }
    }
    return levels;
}

}  // namespace

double alongWallMm(double corner_mm, double scallop_mm) {
    const double ridge_mm = std::min(scallop_mm, corner_mm);
    return 2 * std::sqrt(2 * corner_mm * ridge_mm - ridge_mm * ridge_mm);
}

std::vector<double> formLevels(const FormSite& site, const ToolAssembly& tool, double step_down_mm,
                               double scallop_mm) {
    if (tool.type == ToolType::Chamfer) return chamferLevels(site, tool);
    return wallLevels(site, tool.corner_radius_mm, step_down_mm, scallop_mm);
}

}  // namespace stepmill
