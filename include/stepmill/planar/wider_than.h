#pragma once

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// Is the region somewhere wider than that: does it hold a disc of a larger diameter? False for an empty one.
/// O(n) for what is plainly wide, else a clearance diagram.
bool isWiderThan(const Region& region, double width_mm, const Tolerances& tol);
/// The components that are, untouched.
Region componentsWiderThan(const Region& region, double width_mm, const Tolerances& tol);

}  // namespace stepmill
