#include "stepmill/access/slivers.h"

#include "stepmill/planar/wider_than.h"

namespace stepmill::access {

Region withoutSliverComponents(const Region& region, const Tolerances& tol) {
    Region kept;
    for (const Region& component : components(region))
        if (isWiderThan(component, tol.sliver_mm, tol)) append(kept, component);
    return kept;
}

}  // namespace stepmill::access
