#pragma once

#include <vector>

#include "stepmill/planar/region.h"
#include "support/random_regions.h"

namespace stepmill::test {

/// The point that far from the centre in that direction.
Vec2 polar(const Vec2& centre, double radius_mm, double angle_rad);

/// Adds the loops of `hole` turned round.
/// \pre hole lies in the region
void addHole(Region& region, const Region& hole);

/// Counter-clockwise loop through the corners, some of them rounded by up to the share of the largest radius
/// that has room; from share 1 on some roundings meet their neighbours with nothing, or nanometres, between.
Loop filleted(const std::vector<Vec2>& corners, double largest_share, Random& random);

/// Counter-clockwise loop through the corners, some edges bent to shallow arcs.
Loop bulged(const std::vector<Vec2>& corners, Random& random);

}  // namespace stepmill::test
