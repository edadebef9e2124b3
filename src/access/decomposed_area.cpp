#include "stepmill/access/access.h"

#include "access/slivers.h"
#include "access/swept.h"
#include "stepmill/core/error.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

void append(Region& all, const Region& more) {
    all.loops.insert(all.loops.end(), more.loops.begin(), more.loops.end());
}

/// Of the centres, those components from which the disc reaches some of the target's `fresh` part. Beside
/// open edges others do nothing.
Region centresThatClear(const FeatureGround& ground, const Region& centres, const Region& fresh,
                        double radius_mm) {
    const Tolerances& tol = ground.tolerances();
    Region useful;
    for (const Region& component : components(centres)) {
        const Region cleared = intersect(access::swept(component, radius_mm, tol), fresh, tol);
        if (area(cleared) > tol.area_mm2) append(useful, component);
    }
    return useful;
}

}  // namespace

DecomposedArea decomposedArea(const FeatureGround& ground, const AccessibleArea* m, const AccessibleArea& n) {
    if (!m || m->accessible.empty()) return {n.free_centres, n.accessible, {}, n.coverable_area_mm2};
    STEPMILL_CHECK(m->radius_mm >= n.radius_mm, "the first tool of a pair is the larger one");
    if (n.free_centres.empty()) return {};

    const Tolerances& tol = ground.tolerances();
    DecomposedArea found;
    const Region done = offset(m->accessible, -n.radius_mm, tol);                               // B_mn
    found.centres = access::withoutSliverComponents(subtract(n.free_centres, done, tol), tol);  // C
    found.cleared_centres = intersect(n.free_centres, done, tol);
    if (found.centres.empty()) return found;

    const Region fresh = access::withoutSliverComponents(subtract(n.coverable, m->coverable, tol), tol);
    found.new_area_mm2 = area(fresh);
    if (!ground.walledIn()) found.centres = centresThatClear(ground, found.centres, fresh, n.radius_mm);
    found.area = access::swept(found.centres, n.radius_mm, tol);  // D_mn
    return found;
}

}  // namespace stepmill
