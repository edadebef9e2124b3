#include "sequence/surrogates/held_off.h"

#include <algorithm>

#include "sequence/holder/holder_limits.h"
#include "stepmill/access/lumps.h"
#include "stepmill/core/parallel.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// What some of the tools are kept off and no tool reaches.
Region outOfReach(const std::vector<Region>& held_off, const std::vector<CoveredGround>& covered,
                  const Tolerances& tol) {
    Region rest = held_off.empty() ? Region{} : unite(held_off, tol);
    // The smallest cutters reach most.
    for (auto tool = covered.rbegin(); tool != covered.rend() && !rest.empty(); ++tool)
        rest = withoutCrumbs(subtract(rest, tool->coverable, tol), tol);
    return rest;
}

/// The lumps with the tools that reach all of each.
std::vector<BlockedLump> describe(const std::vector<Region>& lumps, const ToolReach& held_off,
                                  const std::vector<CoveredGround>& covered, const Tolerances& tol) {
    std::vector<BlockedLump> described;
    for (const Region& lump : lumps) {
        BlockedLump blocked{lump, area(lump), {}, held_off.exclusion()->text};
        for (const CoveredGround& other : covered)
            if (other.tool_id != held_off.tool_id && covers(other.coverable, lump, tol.sliver_mm, tol))
                blocked.surrogates.push_back(other.tool_id);
        described.push_back(std::move(blocked));
    }
    return described;
}

/// What the cutter alone reaches, without ground that no tool clears.
CutterArea withoutGround(CutterArea area, const Region& given_up, double depth_mm, const Tolerances& tol) {
    if (given_up.empty()) return area;
    area.opens_target = false;
    area.swept = SureSweep(area.free_centres, area.radius_mm, given_up, tol);
    area.coverable = subtract(area.coverable, given_up, tol);
    area.coverable_area_mm2 = stepmill::area(area.coverable);
    area.access_volume_mm3 = area.coverable_area_mm2 * depth_mm;
    return area;
}

}  // namespace

HeldOffTools heldOffTools(const SequenceJob& job, const std::vector<ToolReach>& reaches) {
    const Tolerances& tol = job.tolerances();
    HeldOffTools found;
    found.own.resize(reaches.size());
    found.held_off.resize(reaches.size());
    parallelFor(reaches.size(), [&](std::size_t i) {
        job.checkTime();
        const ToolReach& reach = reaches[i];
        if (!isHeldOff(reach) || reach.collision_free_area_mm2 <= tol.area_mm2) return;
        auto own = collisionFreeArea(job.ground, job.library.tool(reach.tool_id), reach);
        if (!own || own->coverable_area_mm2 <= tol.area_mm2) return;
        found.held_off[i] = withoutCrumbs(subtract(reach.cutter.coverable, own->coverable, tol), tol);
        found.own[i] = std::move(*own);
    });
    for (std::size_t i = 0; i < reaches.size(); ++i) {
        const ToolReach& reach = reaches[i];
        if (!found.own[i] && reach.exclusion() != nullptr) continue;
        const CutterArea& area = found.own[i] ? *found.own[i] : reach.own();
        // Drills make holes.
        if (!job.library.tool(reach.tool_id).isDrill() && !area.coverable.empty())
            found.covered.push_back({reach.tool_id, area.coverable});
    }
    found.out_of_reach = outOfReach(found.held_off, found.covered, tol);
    return found;
}

std::vector<ToolReach> withSurrogates(const SequenceJob& job, const HeldOffTools& held_off,
                                      const Region& given_up, std::vector<ToolReach> reaches) {
    const Tolerances& tol = job.tolerances();
    const Region none_reaches =
        given_up.empty() ? held_off.out_of_reach : unite(held_off.out_of_reach, given_up, tol);
    parallelFor(reaches.size(), [&](std::size_t i) {
        if (!held_off.own[i]) return;
        ToolReach& reach = reaches[i];
        Region others = held_off.held_off[i];
        if (!none_reaches.empty()) others = subtract(others, none_reaches, tol);
        const std::vector<Region> lumps = lumpsOf(others, 2 * reach.cutter.radius_mm, tol);
        if (lumps.empty()) {
            reach = limitedTo(reach, *held_off.own[i]);
            return;
        }
        std::vector<BlockedLump> described = describe(lumps, reach, held_off.covered, tol);
        reach.collision_free_area_mm2 = held_off.own[i]->coverable_area_mm2;
        const double depth_mm = job.feature().depth_mm();
        reach.use = WithSurrogates{*held_off.own[i], withoutGround(reach.cutter, none_reaches, depth_mm, tol),
                                   std::move(described)};
    });
    return reaches;
}

}  // namespace stepmill
