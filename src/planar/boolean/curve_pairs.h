#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

#include "planar/boolean/arrangement.h"

namespace stepmill::planar {

/// Calls visit(i, j), i < j, for all pairs of boxes that come within `slack_mm` of each other.
template <typename Visit>
void forOverlappingBoxes(const std::vector<Curve>& curves, double slack_mm, Visit visit) {
    const auto at = [&](int index) -> const Box2& { return curves[static_cast<std::size_t>(index)].box; };
    std::vector<int> order(curves.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
                     [&](int a, int b) { return at(a).min().x() < at(b).min().x(); });
    std::vector<int> active;
    for (const int i : order) {
        const Box2 box = grown(at(i), slack_mm);
        std::erase_if(active, [&](int j) { return at(j).max().x() < box.min().x(); });
        for (const int j : active)
            if (at(j).intersects(box)) visit(std::min(i, j), std::max(i, j));
        active.push_back(i);
    }
}

/// Does one of the two begin where the other ends, in the same loop?
bool adjacent(const Curve& a, const Curve& b);

/// Do two neighbouring edges cross at p, rather than meet at their corner? Rounding lets edges that touch
/// tangentially at their corner cross once more, micrometres away and a nanometre deep.
bool crossesBesideCorner(const Curve& a, const Curve& b, const Vec2& p);

}  // namespace stepmill::planar
