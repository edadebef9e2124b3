#pragma once

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill::clearance {

/// Points no farther than `distance_mm` from the boundary: what a disc sweeps on its way along each edge,
/// united by Booleans. Hundreds of times slower than a level of the profile, but without any need for edges
/// to agree on vertices: the way out where rounding keeps them from that.
/// O(n log n) Booleans for n edges.
Region bandAround(const Region& region, double distance_mm, const Tolerances& tol);

}  // namespace stepmill::clearance
