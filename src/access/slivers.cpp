#include "stepmill/access/slivers.h"

#include "stepmill/planar/wider_than.h"

namespace stepmill::access {

Region withoutSliverComponents(const Region& region, const Tolerances& tol) {
    return componentsWiderThan(region, tol.sliver_mm, tol);
}

}  // namespace stepmill::access
