#pragma once

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// All that a disc touches on its way along lines and arcs, which may cross and touch themselves and turn as
/// tightly as they like. Exact but for rounding to the grid; a way without segments gives the disc.
///
/// Both sides of the way, one forward and one back, are one closed curve with half a circle round each end:
/// on the outside of a corner it follows the disc round the corner, on the inside it goes back round it. It
/// winds round a point as often as the way comes to within the radius of it, so the region is where it winds
/// at all.
/// \pre radius_mm > 0
/// O(n log n + k) for n segments whose sides cross k times.
Region discSweep(const Path& way, double radius_mm, const Tolerances& tol);

}  // namespace stepmill
