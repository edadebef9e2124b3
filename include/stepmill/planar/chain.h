#pragma once

#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill {

/// Is the second edge, which starts where the first ends, another piece of the same line or arc? False where
/// both would be a whole turn, which as one edge would end where it begins. O(1).
bool goesOn(const Vec2& from, const Segment& first, const Segment& second);

/// Ways of one edge or none as chains: those that go on where the one before ended are one, pieces of one
/// line or arc one edge. What a disc sweeps along them is the same, in fewer pieces. O(ways).
std::vector<Path> chained(const std::vector<Path>& ways);

}  // namespace stepmill
