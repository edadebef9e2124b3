#include "access/swept.h"

#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill::access {

Region swept(const Region& centres, double radius_mm, const Tolerances& tol) {
    std::vector<Region> grown;
    for (const Region& component : components(centres))
        grown.push_back(offset(component, radius_mm, tol));
    if (grown.empty()) return {};
    return grown.size() == 1 ? std::move(grown.front()) : unite(grown, tol);
}

Region sweptForSure(const AccessibleArea& area, const Tolerances& tol) {
    const Region wide = offset(area.free_centres, -halfSliverMm(tol), tol);
    Region sure = swept(wide, area.radius_mm + halfSliverMm(tol), tol);
    return area.given_up.empty() ? sure : subtract(sure, area.given_up, tol);
}

}  // namespace stepmill::access
