#include <algorithm>

#include <fmt/format.h>

#include "access/entry.h"
#include "access/slot_middles.h"
#include "access/suitability.h"
#include "stepmill/access/access.h"
#include "stepmill/access/collision.h"
#include "stepmill/access/lumps.h"
#include "stepmill/access/slivers.h"
#include "stepmill/access/swept.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

using access::Blocker;

/// Areas of one tool that differ by no more than this share are the same.
constexpr double kSameShare = 1e-5;

/// C_t before the question how to get there, of a disc that comes so near to walls.
Region freeCentres(const FeatureGround& ground, double radius_mm, double kept_off_mm) {
    // Closed all round, a centre outside the target would have to reach over a wall.
    if (ground.walledIn()) return ground.targetOffset(-kept_off_mm);
    return subtract(ground.targetOffset(radius_mm), ground.obstructionOffset(kept_off_mm),
                    ground.tolerances());
}

/// The components of C_t; of those that stand for slots of the cutter's own width more is known.
struct FreeCentres {
    std::vector<Region> components;
    std::vector<access::SlotCentres> slots;

    const access::SlotCentres* slotOf(const Region& component) const {
        const auto found = std::find_if(slots.begin(), slots.end(), [&](const access::SlotCentres& slot) {
            return contains(component, slot.middles.front().start);
        });
        return found == slots.end() ? nullptr : &*found;
    }
};

FreeCentres freeCentresOf(const FeatureGround& ground, double radius_mm) {
    const Tolerances& tol = ground.tolerances();
    const Region all = freeCentres(ground, radius_mm, radius_mm);
    const Region wide = ground.walledIn() ? all : access::withoutSliverComponents(all, tol);
    FreeCentres found{components(wide), {}};
    if (!ground.hasSlotOf(radius_mm)) return found;
    const Region sure = access::withoutSliverComponents(wide, tol);
    found.slots =
        access::slotCentres(ground, radius_mm, sure, freeCentres(ground, radius_mm, radius_mm - tol.fit_mm));
    if (found.slots.empty()) return found;
    Region together = access::besideSlots(ground, radius_mm, sure, found.slots);
    for (const access::SlotCentres& slot : found.slots)
        append(together, slot.strip);
    found.components = components(together);
    return found;
}

/// In words, why the tool has no areas.
Exclusion unreached(const FeatureGround& ground, const ToolAssembly& tool, ExclusionReason reason) {
    if (reason == ExclusionReason::TooWide)
        return {reason, fmt::format("is {:.4g} mm wide, the widest cutter that fits is {:.4g} mm",
                                    tool.diameter_mm, ground.widestCutterMm())};
    return {reason, fmt::format("fits, but there is no open edge, no room for a helix or a straight ramp of "
                                "{:.4g} mm, and it does not cut to its centre",
                                tool.diameter_mm)};
}

/// Keeps the components the tool can get into. Were any left out?
bool keepEnterable(const FeatureGround& ground, const ToolAssembly& tool, FreeCentres centres,
                   CutterArea& found) {
    bool all = true;
    for (Region& component : centres.components) {
        const access::SlotCentres* slot = centres.slotOf(component);
        const auto entry = access::findEntry(ground, tool, slot != nullptr ? slot->along : component);
        all = all && entry.has_value();
        if (!entry) continue;
        found.entries.push_back(*entry);
        if (slot != nullptr)
            found.slot_middles.insert(found.slot_middles.end(), slot->middles.begin(), slot->middles.end());
        for (Loop& loop : component.loops)
            found.free_centres.loops.push_back(std::move(loop));
    }
    return all;
}

void measureAreas(const FeatureGround& ground, bool all_components, CutterArea& found) {
    const Tolerances& tol = ground.tolerances();
    // The target's own diagram answers where nothing was left out.
    const bool inside = ground.walledIn() && found.slot_middles.empty();
    found.opens_target = inside && all_components;
    found.accessible = found.opens_target ? ground.targetOpening(found.radius_mm)
                                          : access::swept(found.free_centres, found.radius_mm, tol);
    found.coverable = inside ? found.accessible : intersect(found.accessible, ground.feature().target, tol);
    found.swept = SureSweep(found.free_centres, found.radius_mm, {}, tol);
    found.coverable_area_mm2 = area(found.coverable);
    found.access_volume_mm3 = found.coverable_area_mm2 * ground.feature().depth_mm();
}

/// The areas as the obstruction alone has them; why, when there are none.
std::optional<ExclusionReason> reachAreas(const FeatureGround& ground, const ToolAssembly& tool,
                                          CutterArea& found) {
    FreeCentres centres = freeCentresOf(ground, found.radius_mm);
    if (centres.components.empty()) return ExclusionReason::TooWide;
    const bool all_components = keepEnterable(ground, tool, std::move(centres), found);
    if (found.free_centres.empty()) return ExclusionReason::NoEntry;
    measureAreas(ground, all_components, found);
    return std::nullopt;
}

/// Does some cylinder come nearer to standing material than it may at an entry beside the free centres?
bool touchesAtEntry(const FeatureGround& ground, const std::vector<Blocker>& blockers,
                    const CutterArea& found) {
    return std::any_of(found.entries.begin(), found.entries.end(), [&](const Entry& entry) {
        return entry.kind == EntryKind::OpenEdge &&
               std::any_of(blockers.begin(), blockers.end(), [&](const Blocker& blocker) {
                   const Region& section = ground.feature().obstacles[blocker.obstacle].section;
                   return contains(section, entry.at) ||
                          distanceToBoundary(section, entry.at) < blocker.radius_mm;
               });
    });
}

/// Areas and entries with shank and holder clear of everything; nothing when no centre is left.
std::optional<CutterArea> clearOfHolder(const FeatureGround& ground, const std::vector<Blocker>& blockers,
                                        const ToolAssembly& tool) {
    const FeatureGround kept_off(access::withoutHolder(ground, blockers, tool.radius_mm()),
                                 ground.tolerances());
    if (kept_off.feature().target.empty()) return std::nullopt;
    CutterArea found;
    found.radius_mm = tool.radius_mm();
    if (reachAreas(kept_off, tool, found)) return std::nullopt;
    found.opens_target = false;  // but what is left of the target beside the holder
    found.wider_obstruction = kept_off.feature().obstruction;
    return found;
}

/// Is all that `of` covers covered, but for skins?
bool reachesTheSame(const CutterArea& area, const CutterArea& of, const Tolerances& tol) {
    const double slack_mm2 = std::max(tol.area_mm2, kSameShare * of.coverable_area_mm2);
    if (area.coverable_area_mm2 >= of.coverable_area_mm2 - slack_mm2) return true;
    return access::withoutSliverComponents(subtract(of.coverable, area.coverable, tol), tol).empty();
}

Exclusion collides(const FeatureGround& ground, const ToolAssembly& tool,
                   const std::vector<Blocker>& blockers, const ToolReach& found, double lost_mm2) {
    const double depth_mm = ground.feature().depth_mm();
    if (found.collision_free_area_mm2 <= ground.tolerances().area_mm2 && tool.stick_out_mm < depth_mm)
        return {ExclusionReason::TooShort,
                fmt::format("reaches {:.4g} mm, the floor is {:.4g} mm deep", tool.stick_out_mm, depth_mm)};
    const Blocker& lowest =
        *std::min_element(blockers.begin(), blockers.end(),
                          [](const auto& a, const auto& b) { return a.height_mm < b.height_mm; });
    return {ExclusionReason::HolderCollision,
            fmt::format("shank or holder ({:.4g} mm wide at {:.4g} mm over the tip{}) would touch standing "
                        "material over {:.4g} of {:.4g} mm2",
                        2 * lowest.radius_mm, lowest.height_mm, clearanceWords(tool), lost_mm2,
                        found.cutter.coverable_area_mm2)};
}

/// Fills in the collision-free area; the exclusion when it lacks something of the coverable area. Where
/// shank or holder only cost centres that are not needed, the areas are made anew without these.
std::optional<Exclusion> checkCollisions(const FeatureGround& ground, const ToolAssembly& tool,
                                         ToolReach& found) {
    CutterArea& cutter = found.cutter;
    found.collision_free_area_mm2 = cutter.coverable_area_mm2;
    const std::vector<Blocker> blockers = access::blockers(ground.feature(), tool);
    if (blockers.empty()) return std::nullopt;
    const Tolerances& tol = ground.tolerances();
    const bool hit = std::any_of(blockers.begin(), blockers.end(), [&](const Blocker& blocker) {
        return access::losesCentres(ground, blocker, cutter.free_centres);
    });
    if (!hit && !touchesAtEntry(ground, blockers, cutter)) return std::nullopt;
    const Region centres = access::collisionFreeCentres(ground, blockers, cutter.free_centres);
    const Region swept = access::swept(centres, cutter.radius_mm, tol);
    const Region lost = access::withoutSliverComponents(subtract(cutter.coverable, swept, tol), tol);
    if (lost.empty()) {
        auto clear = clearOfHolder(ground, blockers, tool);
        if (clear && reachesTheSame(*clear, cutter, tol)) {
            cutter = std::move(*clear);
            found.collision_free_area_mm2 = cutter.coverable_area_mm2;
            return std::nullopt;
        }
    }
    found.collision_free_area_mm2 = std::max(0.0, cutter.coverable_area_mm2 - area(lost));
    return collides(ground, tool, blockers, found, area(lost));
}

}  // namespace

const CutterArea& ToolReach::own() const {
    if (const Limited* less = limited()) return less->whole_tool;
    if (const WithSurrogates* helped = surrogates()) return helped->whole_tool;
    return cutter;
}

const CutterArea& ToolReach::cleared() const {
    const WithSurrogates* helped = surrogates();
    return helped != nullptr ? helped->together : own();
}

namespace {

/// \param explain  tells why the tool has no areas
ToolReach reachOf(const FeatureGround& ground, const ToolAssembly& tool, const std::string& material,
                  const std::function<Exclusion(ExclusionReason)>& explain) {
    ToolReach found;
    found.tool_id = tool.id;
    found.cutter.radius_mm = tool.radius_mm();
    auto excluded = tool.isDrill() ? access::unsuitableDrill(ground, tool, material)
                                   : access::unsuitable(ground, tool, material);
    if (!tool.isDrill() && !(excluded && excluded->reason == ExclusionReason::WrongType)) {
        if (const auto unreached = reachAreas(ground, tool, found.cutter)) {
            if (!excluded) excluded = explain(*unreached);
        } else {
            auto collision = checkCollisions(ground, tool, found);
            if (!excluded) excluded = std::move(collision);
        }
    }
    if (excluded) found.use = std::move(*excluded);
    return found;
}

}  // namespace

ToolReach toolReach(const FeatureGround& ground, const ToolAssembly& tool, const std::string& material) {
    return reachOf(ground, tool, material,
                   [&](ExclusionReason reason) { return unreached(ground, tool, reason); });
}

ToolReach reachInLump(const FeatureGround& ground, const ToolAssembly& tool, const std::string& material) {
    return reachOf(ground, tool, material, [](ExclusionReason reason) {
        return Exclusion{reason, toString(reason)};
    });
}

std::optional<CutterArea> collisionFreeArea(const FeatureGround& ground, const ToolAssembly& tool,
                                            const ToolReach& reach) {
    const Exclusion* excluded = reach.exclusion();
    if (excluded == nullptr || excluded->reason != ExclusionReason::HolderCollision) return std::nullopt;
    if (tool.isDrill() || reach.cutter.free_centres.empty()) return std::nullopt;
    return clearOfHolder(ground, access::blockers(ground.feature(), tool), tool);
}

ToolReach limitedTo(const ToolReach& excluded, CutterArea whole_tool) {
    ToolReach reach;
    reach.tool_id = excluded.tool_id;
    reach.cutter = excluded.cutter;
    reach.collision_free_area_mm2 = whole_tool.coverable_area_mm2;
    const Exclusion* why = excluded.exclusion();
    reach.use = Limited{std::move(whole_tool), why != nullptr ? why->text : std::string()};
    return reach;
}

DepthLimit depthLimitOf(const FeatureGround& ground, const ToolAssembly& tool, const CutterArea& area) {
    const Feature& feature = ground.feature();
    DepthLimit limit{feature.floor_z_mm, 0};
    for (const HolderCylinder& cylinder : access::cylindersOf(tool)) {
        const auto blocks = [&](const Obstacle& obstacle) {
            const auto index = static_cast<std::size_t>(&obstacle - feature.obstacles.data());
            const Blocker blocker{index, cylinder.diameter_mm / 2, cylinder.bottom_mm};
            return access::losesCentres(ground, blocker, area.free_centres);
        };
        // Standing material only shrinks upwards, so those that block lie below those that do not.
        const auto free = std::partition_point(feature.obstacles.begin(), feature.obstacles.end(), blocks);
        if (free == feature.obstacles.begin()) continue;
        const double clear_z_mm = std::prev(free)->top_z_mm;
        const double needed_mm = clear_z_mm - feature.floor_z_mm;
        // A holder moves up with the stick-out; the shank does not, so that must not be lower at all.
        limit.stick_out_mm =
            std::max(limit.stick_out_mm, access::isOfHolder(tool, cylinder)
                                             ? tool.stick_out_mm + needed_mm - cylinder.bottom_mm
                                             : needed_mm);
        limit.floor_z_mm = std::max(limit.floor_z_mm, clear_z_mm - cylinder.bottom_mm);
    }
    return limit;
}

double leastStickOutMm(const ToolAssembly& tool, const std::function<bool(const ToolAssembly&)>& clears) {
    if (!tool.stick_out_range) return tool.stick_out_mm;
    const StickOutRange range = *tool.stick_out_range;
    const auto at = [&](int step) {
        return std::min(range.shortest_mm + step * kStickOutStepMm, range.longest_mm);
    };
    int too_short = -1;
    int long_enough = static_cast<int>(std::ceil((range.longest_mm - range.shortest_mm) / kStickOutStepMm));
    while (long_enough - too_short > 1) {
        const int middle = (too_short + long_enough) / 2;
        (clears(setTo(tool, at(middle))) ? long_enough : too_short) = middle;
    }
    return at(long_enough);
}

double leastStickOutMm(const FeatureGround& ground, const ToolAssembly& tool, const CutterArea& area) {
    return leastStickOutMm(tool, [&](const ToolAssembly& shorter) {
        const std::vector<Blocker> blockers = access::blockers(ground.feature(), shorter);
        return !access::meetsOwnMaterial(ground, shorter, area.free_centres) &&
               !touchesAtEntry(ground, blockers, area) &&
               std::none_of(blockers.begin(), blockers.end(), [&](const Blocker& blocker) {
                   return access::losesCentres(ground, blocker, area.free_centres);
               });
    });
}

}  // namespace stepmill
