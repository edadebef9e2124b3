#pragma once

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill::clearance {

/// Points no farther than `distance_mm` from the boundary. A disc sweeps a band along each edge, and Booleans
/// unite the bands. This is hundreds of times slower than a level of the profile, but edges need not agree on
/// vertices: it serves where rounding keeps them from agreeing.
/// O(n log n) Booleans for n edges.
Region bandAround(const Region& region, double distance_mm, const Tolerances& tol);

}  // namespace stepmill::clearance
