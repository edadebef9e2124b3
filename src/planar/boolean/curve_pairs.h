#pragma once

#include <utility>
#include <vector>

#include "planar/boolean/arrangement.h"

namespace stepmill::planar {

/// Pairs of boxes, i < j, that come within `slack_mm` of each other, in rising order.
std::vector<std::pair<int, int>> overlappingBoxes(const std::vector<Curve>& curves, double slack_mm);

/// Does one of the two begin where the other ends, in the same loop?
bool adjacent(const Curve& a, const Curve& b);

/// Do two neighbouring edges cross at p, rather than meet at their corner? Rounding lets edges that touch
/// tangentially at their corner cross once more, micrometres away and a nanometre deep.
bool crossesBesideCorner(const Curve& a, const Curve& b, const Vec2& p);

}  // namespace stepmill::planar
