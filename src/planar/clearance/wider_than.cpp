#include "stepmill/planar/wider_than.h"

#include "stepmill/planar/clearance_diagram.h"

namespace stepmill {

bool isWiderThan(const Region& region, double width_mm, const Tolerances& tol) {
    // Every planar region holds a disc of radius area / perimeter, so most need no closer look.
    if (area(region) > width_mm / 2 * perimeter(region)) return true;
    const auto disc = ClearanceDiagram(region, tol).largestInscribedDisc();
    return disc && 2 * disc->radius_mm > width_mm;
}

Region componentsWiderThan(const Region& region, double width_mm, const Tolerances& tol) {
    Region wide;
    for (const Region& component : components(region))
        if (isWiderThan(component, width_mm, tol)) append(wide, component);
    return wide;
}

}  // namespace stepmill
