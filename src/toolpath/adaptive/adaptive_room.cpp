#include "toolpath/adaptive/adaptive_room.h"

#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/toolpath/swept_region.h"

namespace stepmill::toolpath {

RoomFinder::RoomFinder(const ClearingTask& task, double radius_mm, bool limited, const Tolerances& tol)
    : task_(task), radius_mm_(radius_mm), limited_(limited), tol_(tol) {}

AdaptiveRoom RoomFinder::roomOf(const RingFamily::Component& component) const {
    AdaptiveRoom found;
    found.room = component.guarded;
    // Where the task is less than what is free and not clear, its limit is a wall.
    if (limited_) found.room = intersect(found.room, unite(task_.centres, task_.cleared_centres, tol_), tol_);
    if (!task_.cleared_centres.empty()) found.cleared = intersect(task_.cleared_centres, found.room, tol_);
    if (component.open_sides.empty()) return found;
    const Region air = airBeside(component);
    found.room = unite(found.room, air, tol_);
    found.cleared = unite(found.cleared, air, tol_);
    return found;
}

/// A band along the open sides where the disc meets neither target nor what must stay, nor its holder that.
Region RoomFinder::airBeside(const RingFamily::Component& component) const {
    std::vector<Path> sides;
    for (const Edge& side : component.open_sides)
        sides.push_back({side.from, {side.segment}});
    const double reach_mm = radius_mm_ + tol_.guard_mm;
    Region air = sweptRegion(sides, radius_mm_, tol_);
    const Box2 around = grown(boundingBox(air), 2 * radius_mm_);
    const Region near = makeRectangle(around.min(), around.max());
    const auto keepOff = [&](const Region& region, double distance_mm) {
        const Region met = intersect(region, near, tol_);
        if (!met.empty()) air = subtract(air, offset(met, distance_mm, tol_), tol_);
    };
    keepOff(task_.target, radius_mm_ - onBoundaryMm(tol_));
    keepOff(task_.obstruction, reach_mm);
    for (const KeptOff& kept : task_.kept_off)
        keepOff(kept.section, kept.distance_mm + tol_.guard_mm);
    return air;
}

}  // namespace stepmill::toolpath
