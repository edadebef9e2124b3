#pragma once

#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// Lines and arcs for a dense chain of points on a curve with material on its left.
///
/// The fit lies on the safe side, the right: between `tolerance_mm` outside and a twentieth of that
/// inside the curve. It starts and ends exactly at the first and the last point (on the grid); arcs are
/// laid through points pushed out by up to half the tolerance, less and less towards the ends.
/// Greedy, each piece as long as the tolerance lets it be. O(n log n) for n points.
std::vector<Segment> fitSafeSide(const std::vector<Vec2>& points, double tolerance_mm);

}  // namespace stepmill::layers
