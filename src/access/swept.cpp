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

}  // namespace stepmill::access
