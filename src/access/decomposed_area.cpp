#include "stepmill/access/access.h"

#include "stepmill/access/slivers.h"
#include "stepmill/access/swept.h"
#include "stepmill/core/error.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// Keeps the components of C from which the disc reaches some of the target's `fresh` part, as others beside
/// open edges do nothing, and unites what they sweep to D.
void sweepUseful(const FeatureGround& ground, const Region& centres, const Region& fresh, double radius_mm,
                 DecomposedArea& found) {
    const Tolerances& tol = ground.tolerances();
    std::vector<Region> swept;
    for (const Region& component : components(centres)) {
        Region disc_reach = offset(component, radius_mm, tol);
        // Inside walls a centre outside B_mn always clears something.
        if (!ground.walledIn() && area(intersect(disc_reach, fresh, tol)) <= tol.area_mm2) continue;
        append(found.centres, component);
        swept.push_back(std::move(disc_reach));
    }
    if (!swept.empty()) found.area = unite(swept, tol);
}

/// Both tools sweep all they can inside the target: its own diagram knows what the smaller one has left.
DecomposedArea insideTarget(const FeatureGround& ground, const CutterArea& m, const CutterArea& n) {
    const Tolerances& tol = ground.tolerances();
    DecomposedArea found;
    // Opening the target by half a sliver more is opening m's centres by that: see SureSweep.
    const Region rest = ground.targetRestCentres(m.radius_mm + access::halfSliverMm(tol), n.radius_mm);
    found.centres = access::withoutSliverComponents(rest, tol);
    found.new_area_mm2 = std::max(0.0, n.coverable_area_mm2 - m.coverable_area_mm2);
    if (found.centres.empty() || found.new_area_mm2 <= tol.area_mm2) return {{}, {}, n.free_centres, 0};
    found.area = access::swept(found.centres, n.radius_mm, tol);
    found.cleared_centres = subtract(n.free_centres, found.centres, tol);
    return found;
}

}  // namespace

DecomposedArea decomposedArea(const FeatureGround& ground, const CutterArea* m, const CutterArea& n) {
    if (!m || m->accessible.empty()) return {n.free_centres, n.accessible, {}, n.coverable_area_mm2};
    STEPMILL_CHECK(m->radius_mm >= n.radius_mm, "the first tool of a pair is the larger one");
    if (n.free_centres.empty()) return {};
    if (m->opens_target && n.opens_target) return insideTarget(ground, *m, n);

    const Tolerances& tol = ground.tolerances();
    DecomposedArea found;
    const Region fresh = access::withoutSliverComponents(subtract(n.coverable, m->coverable, tol), tol);
    if (fresh.empty()) {
        // A_n = A_m on T: no centre is left to visit, and every disc stays within what m has swept.
        found.cleared_centres = n.free_centres;
        return found;
    }
    found.new_area_mm2 = area(fresh);
    const Region done = m->swept.shrunk(n.radius_mm);                                                  // B_mn
    const Region centres = access::withoutSliverComponents(subtract(n.free_centres, done, tol), tol);  // C
    found.cleared_centres = intersect(n.free_centres, done, tol);
    sweepUseful(ground, centres, fresh, n.radius_mm, found);  // D_mn
    return found;
}

}  // namespace stepmill
