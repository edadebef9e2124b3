#pragma once

#include <optional>
#include <vector>

#include "planar/boolean/arrangement.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/region.h"

namespace stepmill::planar {

/// Points of the grid lie up to 0.7 nm off the curve they were computed for, so may an arc's centre, and its
/// radius 0.5 nm: 1.9 nm in all. Below the 2 nm that `diagnose` allows.
inline constexpr double kOnCurveMm = 1.95 * kGridMm;

/// Are the two the same circle, run through the same way, but for rounding?
bool sameCircle(const Arc& a, const Arc& b);

/// Joins directed pieces into the loops of a region: neighbouring pieces of one line or circle become one
/// edge again, joints become true intersections on the grid, loops thinner than `thin_mm` go.
/// Nothing if the pieces do not close up, which tells that the arrangement was ambiguous.
std::optional<Region> buildLoops(const Arrangement& arrangement, const std::vector<Piece>& pieces,
                                 double thin_mm);

/// The same region with every loop starting at its lowest, then leftmost vertex, and loops in that order.
Region ordered(Region region);

}  // namespace stepmill::planar
