#include "stepmill/access/slivers.h"

#include "stepmill/planar/clearance_diagram.h"

namespace stepmill::access {
namespace {

bool isWide(const Region& component, const Tolerances& tol) {
    // Every planar region holds a disc of radius area / perimeter, so most need no closer look.
    if (area(component) > tol.sliver_mm / 2 * perimeter(component)) return true;
    const auto disc = ClearanceDiagram(component, tol).largestInscribedDisc();
    return disc && 2 * disc->radius_mm > tol.sliver_mm;
}

}  // namespace

Region withoutSliverComponents(const Region& region, const Tolerances& tol) {
    Region kept;
    for (const Region& component : components(region))
        if (isWide(component, tol))
            kept.loops.insert(kept.loops.end(), component.loops.begin(), component.loops.end());
    return kept;
}

}  // namespace stepmill::access
