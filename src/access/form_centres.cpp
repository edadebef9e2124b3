// Free centres of cutters that are no upright cylinders.

#include "stepmill/access/form_centres.h"

#include <algorithm>

#include "stepmill/access/collision.h"
#include "stepmill/catalog/cutter_form.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// Heights closer than this are one [mm].
constexpr double kSameHeightMm = 1e-6;

const ClearanceDiagram& diagramOf(std::map<std::size_t, ClearanceDiagram>& made, std::size_t index,
                                  const Region& region, const Tolerances& tol) {
    const auto found = made.find(index);
    return found != made.end() ? found->second : made.try_emplace(index, region, tol).first->second;
}

}  // namespace

FormBands::FormBands(const FormGround& ground, const Tolerances& tol) : ground_(ground), tol_(tol) {
    const std::vector<Obstacle>& bands = ground_.must_stand;
    for (std::size_t i = 0; i < bands.size(); ++i)
        goes_on_.push_back(static_cast<char>(i + 1 < bands.size() &&
                                             feature::identical(bands[i].section, bands[i + 1].section)));
}

Region FormBands::grown(std::size_t band, double by_mm) const {
    const Region& section = ground_.must_stand[band].section;
    return section.empty() ? Region{} : diagramOf(bands_, band, section, tol_).offset(by_mm);
}

const ClearanceDiagram& FormBands::shadow(std::size_t band) const {
    const auto found = shadows_.find(band);
    if (found != shadows_.end()) return found->second;
    // From above, so that each is the one above it with one section more.
    std::size_t i = ground_.must_stand.size();
    Region above;
    while (i-- > band) {
        const auto known = shadows_.find(i);
        if (known != shadows_.end()) {
            above = known->second.region();
            continue;
        }
        above = unite(ground_.must_stand[i].section, above, tol_);
        shadows_.try_emplace(i, above, tol_);
    }
    return shadows_.at(band);
}

Region FormBands::grownAbove(std::size_t band, double by_mm) const {
    if (band >= ground_.must_stand.size()) return {};
    const ClearanceDiagram& diagram = shadow(band);
    return diagram.region().empty() ? Region{} : diagram.offset(by_mm);
}

Region FormBands::obstacleGrown(std::size_t index, double by_mm) const {
    const Region& section = ground_.obstacles[index].section;
    return section.empty() ? Region{} : diagramOf(obstacles_, index, section, tol_).offset(by_mm);
}

std::size_t obstacleOver(const std::vector<Obstacle>& obstacles, double z_mm) {
    const auto found = std::find_if(obstacles.begin(), obstacles.end(), [&](const Obstacle& obstacle) {
        return z_mm < obstacle.top_z_mm - kSameHeightMm;
    });
    return static_cast<std::size_t>(found - obstacles.begin());
}

FormCentres::FormCentres(const FormBands& bands, const ToolAssembly& tool)
    : bands_(bands),
      tool_(tool),
      within_(offset(bands.ground().window, -tool.radius_mm() - bands.tolerances().guard_mm,
                     bands.tolerances())) {}

const Region& FormCentres::at(double tip_z_mm) const {
    const auto [found, is_new] = known_.try_emplace(tip_z_mm);
    if (is_new && !within_.empty()) found->second = subtract(within_, keptOff(tip_z_mm), bands_.tolerances());
    return found->second;
}

Region FormCentres::keptOff(double tip_z_mm) const {
    const std::vector<Obstacle>& bands = bands_.ground().must_stand;
    const CutterForm form(tool_);
    const double guard_mm = bands_.tolerances().guard_mm;
    std::vector<Region> kept_off;
    std::size_t band = 0;
    while (band < bands.size() && bands[band].top_z_mm <= tip_z_mm + kSameHeightMm)
        ++band;
    for (; band < bands.size() && bands[band].top_z_mm < tip_z_mm + form.heightMm(); ++band)
        if (!bands_.goesOn(band))
            kept_off.push_back(bands_.grown(band, form.radiusAt(bands[band].top_z_mm - tip_z_mm) + guard_mm));
    kept_off.push_back(bands_.grownAbove(band, form.fullRadiusMm() + guard_mm));
    addHolder(tip_z_mm, kept_off);
    std::erase_if(kept_off, [](const Region& region) { return region.empty(); });
    return kept_off.empty() ? Region{} : unite(kept_off, bands_.tolerances());
}

void FormCentres::addHolder(double tip_z_mm, std::vector<Region>& kept_off) const {
    const std::vector<Obstacle>& obstacles = bands_.ground().obstacles;
    for (const HolderCylinder& cylinder : access::cylindersOf(tool_)) {
        const std::size_t over = obstacleOver(obstacles, tip_z_mm + cylinder.bottom_mm);
        if (over >= obstacles.size()) continue;
        kept_off.push_back(
            bands_.obstacleGrown(over, cylinder.diameter_mm / 2 + bands_.tolerances().guard_mm));
    }
}

}  // namespace stepmill
