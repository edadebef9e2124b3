// Which piece comes after which around a node.

#include "planar/boolean/junction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "planar/segment.h"
#include "stepmill/core/units.h"

namespace stepmill::planar {

namespace {

/// From the end's node to the point so far along its piece.
Vec2 seen(const Arrangement& arrangement, const PieceEnd& end, double length_mm, double reach_mm) {
    const Piece& piece = *end.piece;
    const double share = reach_mm / length_mm;
    const Vec2 p =
        pointAt(arrangement.node(piece.begin), arrangement.segment(piece), end.leaves ? share : 1 - share);
    return p - arrangement.node(end.leaves ? piece.begin : piece.end);
}

/// \param lengths_mm  of the ends' pieces
void sortAround(const Arrangement& arrangement, std::span<const PieceEnd> ends,
                std::span<const double> lengths_mm, std::span<std::size_t> order) {
    // All are looked at from the same distance: of two tangent pieces the one that bends away to the left
    // comes later. A short piece forces short sight on all; rounding then hides which way the others bend,
    // so those that seem to run together are looked at once more without it.
    constexpr double kTogetherRad = 0.3;
    double reach_mm = std::numeric_limits<double>::infinity();
    for (const std::size_t i : order)
        reach_mm = std::min(reach_mm, lengths_mm[i] / 2);
    std::vector<std::pair<double, std::size_t>> by_angle;
    by_angle.reserve(order.size());
    for (const std::size_t i : order) {
        const Vec2 direction = seen(arrangement, ends[i], lengths_mm[i], reach_mm);
        by_angle.emplace_back(std::atan2(direction.y(), direction.x()), i);
    }
    std::sort(by_angle.begin(), by_angle.end());
    // Start after the widest gap, so that no bundle lies across the start.
    const auto gapBefore = [&](std::size_t k) {
        return k == 0 ? by_angle.front().first + 2 * kPi - by_angle.back().first
                      : by_angle[k].first - by_angle[k - 1].first;
    };
    std::size_t start = 0;
    for (std::size_t k = 1; k < by_angle.size(); ++k)
        if (gapBefore(k) > gapBefore(start)) start = k;
    std::size_t bundle = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        order[k] = by_angle[(start + k) % order.size()].second;
        const bool ends_here =
            k + 1 == order.size() || gapBefore((start + k + 1) % order.size()) > kTogetherRad;
        if (!ends_here) continue;
        const std::size_t count = k + 1 - bundle;
        if (count > 1 && count < order.size())
            sortAround(arrangement, ends, lengths_mm, order.subspan(bundle, count));
        bundle = k + 1;
    }
}

}  // namespace

std::vector<std::size_t> counterClockwise(const Arrangement& arrangement, std::span<const PieceEnd> ends) {
    std::vector<std::size_t> order(ends.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::vector<double> lengths_mm;
    lengths_mm.reserve(ends.size());
    for (const PieceEnd& end : ends)
        lengths_mm.push_back(arrangement.lengthOf(*end.piece));
    sortAround(arrangement, ends, lengths_mm, order);
    return order;
}

}  // namespace stepmill::planar
