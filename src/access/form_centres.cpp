// Free centres of cutters that are no upright cylinders.

#include "stepmill/access/form_centres.h"

#include <algorithm>

#include "stepmill/access/collision.h"
#include "stepmill/catalog/cutter_form.h"
#include "stepmill/feature/heights.h"
#include "stepmill/feature/region_compare.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// Stairs farther over the tip than the cutter's form is high, and this much, are no work for it [mm].
constexpr double kAboveFormMm = 1.0;

const ClearanceDiagram& diagramOf(std::map<std::size_t, ClearanceDiagram>& made, std::size_t index,
                                  const Region& region, const Tolerances& tol) {
    const auto found = made.find(index);
    return found != made.end() ? found->second : made.try_emplace(index, region, tol).first->second;
}

}  // namespace

FormRoom::FormRoom(const FormGround& ground, Region window, std::vector<Region> sections,
                   const Tolerances& tol)
    : window_(std::move(window)), sections_(std::move(sections)), tol_(tol) {
    for (std::size_t i = 0; i < sections_.size(); ++i)
        goes_on_.push_back(static_cast<char>(i + 1 < sections_.size() &&
                                             feature::identical(sections_[i], sections_[i + 1])));
    findStairs(ground);
}

void FormRoom::findStairs(const FormGround& ground) {
    bool found = false;
    for (const Obstacle& stair : ground.stairs) {
        const bool here = std::any_of(stair.section->loops.begin(), stair.section->loops.end(),
                                      [&](const Loop& loop) { return contains(window_, loop.start); });
        if (!here) continue;
        if (!found) stairs_bottom_mm_ = stair.bottom_z_mm;
        stairs_top_mm_ = stair.top_z_mm;
        found = true;
    }
}

Region FormRoom::grown(std::size_t band, double by_mm) const {
    const Region& section = sections_[band];
    return section.empty() ? Region{} : diagramOf(bands_, band, section, tol_).offset(by_mm);
}

const ClearanceDiagram& FormRoom::shadow(std::size_t band) const {
    const auto found = shadows_.find(band);
    if (found != shadows_.end()) return found->second;
    const auto above = shadows_.upper_bound(band);
    std::size_t i = above == shadows_.end() ? sections_.size() : above->first;
    Region shadow = above == shadows_.end() ? Region{} : above->second.region();
    while (i-- > band)
        if (!goesOn(i)) shadow = unite(sections_[i], shadow, tol_);
    return shadows_.try_emplace(band, std::move(shadow), tol_).first->second;
}

Region FormRoom::grownAbove(std::size_t band, double by_mm) const {
    if (band >= sections_.size()) return {};
    const ClearanceDiagram& diagram = shadow(band);
    return diagram.region().empty() ? Region{} : diagram.offset(by_mm);
}

FormBands::FormBands(const FormGround& ground, const Tolerances& tol) : ground_(ground), tol_(tol) {
    for (Region& window : components(ground.window)) {
        // Sections end at the window, so each of their loops lies in one of its components.
        std::vector<Region> sections(ground.must_stand.size());
        for (std::size_t i = 0; i < sections.size(); ++i)
            for (const Loop& loop : ground.must_stand[i].section->loops)
                if (contains(window, loop.start)) sections[i].loops.push_back(loop);
        rooms_.emplace_back(ground, std::move(window), std::move(sections), tol);
    }
}

const Region& FormBands::obstacleGrown(std::size_t index, double by_mm, std::size_t room) const {
    const auto [found, is_new] = obstacles_grown_.try_emplace({index, by_mm, room});
    const Region& section = ground_.obstacles[index].section;
    if (is_new && !section.empty())
        found->second =
            intersect(diagramOf(obstacles_, index, section, tol_).offset(by_mm), rooms_[room].window(), tol_);
    return found->second;
}

FormCentres::FormCentres(const FormBands& bands, const ToolAssembly& tool) : bands_(bands), tool_(tool) {
    for (const FormRoom& room : bands.rooms())
        within_.push_back(
            offset(room.window(), -tool.radius_mm() - bands.tolerances().guard_mm, bands.tolerances()));
}

Region FormCentres::from(double top_z_mm, double bottom_z_mm) const {
    Region free;
    for (std::size_t room = 0; room < within_.size(); ++room) {
        if (within_[room].empty() || !meetsStairs(room, top_z_mm, bottom_z_mm)) continue;
        const Region& in_room = inRoom(room, top_z_mm);
        append(free, in_room);
    }
    return free;
}

Region FormCentres::withinWindow() const {
    Region all;
    for (const Region& within : within_)
        append(all, within);
    return all;
}

bool FormCentres::meetsStairs(std::size_t room, double top_z_mm, double bottom_z_mm) const {
    const FormRoom& where = bands_.rooms()[room];
    const double reach_mm = CutterForm(tool_).heightMm() + kAboveFormMm;
    return bottom_z_mm < where.stairsTopMm() && top_z_mm + reach_mm > where.stairsBottomMm();
}

const Region& FormCentres::inRoom(std::size_t room, double tip_z_mm) const {
    const std::pair key(tip_z_mm, room);
    if (const auto found = in_rooms_.find(key); found != in_rooms_.end()) return found->second;
    Region free = subtract(within_[room], keptOff(room, tip_z_mm), bands_.tolerances());
    return in_rooms_.emplace(key, std::move(free)).first->second;
}

std::vector<Region> FormCentres::keptOff(std::size_t room, double tip_z_mm) const {
    const FormRoom& where = bands_.rooms()[room];
    const std::vector<Obstacle>& bands = bands_.ground().must_stand;
    const CutterForm form(tool_);
    const double guard_mm = bands_.tolerances().guard_mm;
    std::vector<Region> kept_off;
    std::size_t band = 0;
    while (band < bands.size() && bands[band].top_z_mm <= tip_z_mm + kSameHeightMm)
        ++band;
    for (; band < bands.size() && bands[band].top_z_mm < tip_z_mm + form.heightMm(); ++band)
        if (!where.goesOn(band))
            kept_off.push_back(where.grown(band, form.radiusAt(bands[band].top_z_mm - tip_z_mm) + guard_mm));
    kept_off.push_back(where.grownAbove(band, form.fullRadiusMm() + guard_mm));
    addHolder(room, tip_z_mm, kept_off);
    std::erase_if(kept_off, [](const Region& region) { return region.empty(); });
    return kept_off;
}

void FormCentres::addHolder(std::size_t room, double tip_z_mm, std::vector<Region>& kept_off) const {
    const std::vector<Obstacle>& obstacles = bands_.ground().obstacles;
    for (const HolderCylinder& cylinder : access::cylindersOf(tool_)) {
        const auto over = access::obstacleAbove(obstacles, tip_z_mm + cylinder.bottom_mm, kSameHeightMm);
        if (!over) continue;
        kept_off.push_back(
            bands_.obstacleGrown(*over, cylinder.diameter_mm / 2 + bands_.tolerances().guard_mm, room));
    }
}

}  // namespace stepmill
