#pragma once

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// The region with its runs of many short lines, as unions of facets' hulls have them, refitted by long lines
/// and arcs on the outside.
///
/// Thousands of lines a tenth of a millimetre long cost every later step, and tell no more than the hulls'
/// own slack. The result covers the region but for `tol.gouge_mm` and exceeds it by `by_mm` or a little more;
/// where the fit does not, the region stays as it is.
///
/// \param by_mm  how far the region is from the true section already
Region smoothHulls(const Region& region, double by_mm, const Tolerances& tol);

}  // namespace stepmill::layers
