#pragma once

#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// Points closer than two grid steps are one.
inline constexpr double kJointMm = 2e-6;

/// Equal but for the grid.
bool sameCircle(const Arc& a, const Arc& b);

/// A closed loop of segments (each from the end of the one before, cyclic): pieces of nothing dropped,
/// pieces of one line or circle merged, begun at its least point; whole circles as two half arcs.
Loop tidyLoop(std::vector<Segment> segments);

/// Loops in an order that depends on their points alone.
void sortLoops(Region& region);

}  // namespace stepmill::layers
