#pragma once

#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill::toolpath {

/// Pairs of arcs with one tangent where they meet, as long as they lie no farther than that from the points
/// in between. The path has a tangent everywhere but where the points turn a corner.
/// \pre neighbours differ; at least two
Path tangentArcs(const std::vector<Vec2>& points, double most_off_mm);

}  // namespace stepmill::toolpath
