#include "planar/boolean/curve_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "planar/boolean/strips.h"
#include "planar/segment.h"
#include "stepmill/core/units.h"

namespace stepmill::planar {

namespace {

/// Boxes a strip has on average, and the most strips.
constexpr std::size_t kBoxesAStrip = 16;
constexpr std::size_t kMostStrips = 512;

/// The boxes' numbers, from left to right.
std::vector<int> byLeft(const std::vector<Box2>& boxes) {
    std::vector<int> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    const auto left = [&](int i) { return boxes[static_cast<std::size_t>(i)].min().x(); };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return left(a) < left(b); });
    return order;
}

}  // namespace

std::vector<std::pair<int, int>> overlappingBoxes(const std::vector<Curve>& curves, double slack_mm) {
    std::vector<std::pair<int, int>> pairs;
    if (curves.empty()) return pairs;
    // Half the slack on either side.
    std::vector<Box2> boxes;
    boxes.reserve(curves.size());
    for (const Curve& curve : curves)
        boxes.push_back(grown(curve.box, slack_mm / 2));
    const auto boxOf = [&](int i) -> const Box2& { return boxes[static_cast<std::size_t>(i)]; };
    const std::size_t count = std::clamp<std::size_t>(boxes.size() / kBoxesAStrip, 1, kMostStrips);
    const Strips strips(boxes, 1, count, byLeft(boxes));
    std::vector<int> active;
    for (std::size_t strip = 0; strip < strips.count(); ++strip) {
        active.clear();
        for (const int i : strips[strip]) {
            const Box2& box = boxOf(i);
            std::erase_if(active, [&](int j) { return boxOf(j).max().x() < box.min().x(); });
            for (const int j : active) {
                // Of the strips that both are in the first one tells.
                const double begin_mm = std::max(box.min().y(), boxOf(j).min().y());
                if (boxOf(j).intersects(box) && strips.of(begin_mm) == strip)
                    pairs.push_back(std::minmax(i, j));
            }
            active.push_back(i);
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

bool adjacent(const Curve& a, const Curve& b) {
    return a.loop == b.loop && (a.segment.to == b.from || b.segment.to == a.from);
}

bool crossesBesideCorner(const Curve& a, const Curve& b, const Vec2& p) {
    double from_corner = std::numeric_limits<double>::infinity();
    if (a.segment.to == b.from) from_corner = std::min(from_corner, (p - b.from).norm());
    if (b.segment.to == a.from) from_corner = std::min(from_corner, (p - a.from).norm());
    constexpr double kDeepMm = 10 * kGridMm;
    if (from_corner / 4 <= kDeepMm) return false;
    const Vec2 ta = tangentAt(a.from, a.segment, shareOf(p, a.from, a.segment));
    const Vec2 tb = tangentAt(b.from, b.segment, shareOf(p, b.from, b.segment));
    // The two curves part by about a quarter of chord times angle in between.
    return from_corner * std::abs(cross(ta, tb)) / 4 > kDeepMm;
}

}  // namespace stepmill::planar
