#pragma once

#include <optional>
#include <vector>

#include "planar/boolean/arrangement.h"
#include "stepmill/planar/region.h"

namespace stepmill::planar {

/// Joins directed pieces into the loops of a region: neighbouring pieces of one line or circle become one
/// edge again, joints become true intersections on the grid, loops thinner than `thin_mm` go.
/// Nothing if the pieces do not close up, which tells that the arrangement was ambiguous.
std::optional<Region> buildLoops(const Arrangement& arrangement, const std::vector<Piece>& pieces,
                                 double thin_mm);

/// The same region with every loop starting at its lowest, then leftmost vertex, and loops in that order.
Region ordered(Region region);

}  // namespace stepmill::planar
