#include "sequence/surrogates/surrogates.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "sequence/holder/holder_limits.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// Only cutters that reach something; drills make holes.
bool isEndMill(const AccessibleArea& area, const ToolLibrary& library) {
    return !library.tool(area.tool_id).isDrill() && !area.coverable.empty();
}

/// What some of `tools` is kept off and no tool reaches.
Region outOfReach(const std::vector<Region>& held_off, const std::vector<const AccessibleArea*>& reach,
                  const Tolerances& tol) {
    Region left = held_off.empty() ? Region{} : unite(held_off, tol);
    // The smallest cutters reach most.
    for (auto tool = reach.rbegin(); tool != reach.rend() && !left.empty(); ++tool)
        left = withoutCrumbs(subtract(left, (*tool)->coverable, tol), tol);
    return left;
}

bool reachesAll(const AccessibleArea& tool, const Region& lump, const Tolerances& tol) {
    return covers(tool.coverable, lump, tol.sliver_mm, tol);
}

std::vector<BlockedLump> describe(const std::vector<Region>& lumps, const AccessibleArea& held_off,
                                  const std::vector<const AccessibleArea*>& reach, const Tolerances& tol) {
    std::vector<BlockedLump> described;
    for (const Region& lump : lumps) {
        BlockedLump blocked{lump, area(lump), {}, held_off.excluded->text};
        for (const AccessibleArea* other : reach)
            if (other->tool_id != held_off.tool_id && reachesAll(*other, lump, tol))
                blocked.surrogates.push_back(other->tool_id);
        described.push_back(std::move(blocked));
    }
    return described;
}

}  // namespace

const AccessibleArea* ownReach(const AccessibleArea& area) {
    if (area.clear_of_holder) return area.clear_of_holder.get();
    return area.excluded ? nullptr : &area;
}

HeldOffTools heldOffTools(const FeatureGround& ground, const ToolLibrary& library,
                          const std::vector<AccessibleArea>& areas) {
    const Tolerances& tol = ground.tolerances();
    HeldOffTools found;
    found.own.resize(areas.size());
    found.held_off.resize(areas.size());
    tbb::parallel_for(std::size_t{0}, areas.size(), [&](std::size_t i) {
        if (!isHeldOff(areas[i]) || areas[i].collision_free_area_mm2 <= tol.area_mm2) return;
        auto own = limitedArea(ground, library.tool(areas[i].tool_id), areas[i]);
        if (!own || own->coverable_area_mm2 <= tol.area_mm2) return;
        found.held_off[i] = withoutCrumbs(subtract(areas[i].coverable, own->coverable, tol), tol);
        found.own[i] = std::make_shared<const AccessibleArea>(std::move(*own));
    });
    for (std::size_t i = 0; i < areas.size(); ++i) {
        const AccessibleArea* reach = found.own[i] ? found.own[i].get() : ownReach(areas[i]);
        if (reach != nullptr && isEndMill(*reach, library)) found.reach.push_back(reach);
    }
    found.out_of_reach = outOfReach(found.held_off, found.reach, tol);
    return found;
}

void admitWithSurrogates(const FeatureGround& ground, const HeldOffTools& held_off, const Region& given_up,
                         std::vector<AccessibleArea>& areas) {
    const Tolerances& tol = ground.tolerances();
    const Region none_reaches =
        given_up.empty() ? held_off.out_of_reach : unite(held_off.out_of_reach, given_up, tol);
    tbb::parallel_for(std::size_t{0}, areas.size(), [&](std::size_t i) {
        if (!held_off.own[i]) return;
        AccessibleArea& area = areas[i];
        area.clear_of_holder = held_off.own[i];
        Region others = held_off.held_off[i];
        if (!none_reaches.empty()) {
            others = subtract(others, none_reaches, tol);
            area.given_up = none_reaches;
            area.opens_target = false;
            area.swept = SureSweep(area.free_centres, area.radius_mm, none_reaches, tol);
            area.coverable = subtract(area.coverable, none_reaches, tol);
            area.coverable_area_mm2 = stepmill::area(area.coverable);
            area.access_volume_mm3 = area.coverable_area_mm2 * ground.feature().depth_mm();
        }
        const std::vector<Region> lumps = lumpsOf(others, 2 * area.radius_mm, tol);
        if (lumps.empty()) {
            area = *held_off.own[i];
            return;
        }
        area.blocked_lumps = describe(lumps, area, held_off.reach, tol);
        area.collision_free_area_mm2 = held_off.own[i]->coverable_area_mm2;
        area.excluded.reset();
    });
}

}  // namespace stepmill
