#include "planar/boolean/curve_pairs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "planar/boolean/grouped.h"
#include "planar/segment.h"
#include "stepmill/core/units.h"

namespace stepmill::planar {

namespace {

/// Boxes a strip has on average, and the most strips.
constexpr std::size_t kBoxesAStrip = 16;
constexpr std::size_t kMostStrips = 512;

/// The plane cut across y.
class Strips {
  public:
    Strips(const std::vector<Box2>& boxes, std::size_t count) : count_(count) {
        Box2 all;
        for (const Box2& box : boxes)
            all.extend(box);
        low_mm_ = all.min().y();
        per_mm_ = static_cast<double>(count) / std::max(all.sizes().y(), kGridMm);
    }
    std::size_t count() const { return count_; }
    std::size_t of(double y_mm) const {
        return std::min(count_ - 1, static_cast<std::size_t>(std::max(0.0, (y_mm - low_mm_) * per_mm_)));
    }

  private:
    std::size_t count_;
    double low_mm_ = 0;
    double per_mm_ = 0;
};

/// The boxes in each strip, from left to right.
struct Entries {
    std::vector<int> boxes;
    Grouped by_strip;
};

Entries entriesOf(const std::vector<Box2>& boxes, const Strips& strips) {
    std::vector<int> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    const auto left = [&](int i) { return boxes[static_cast<std::size_t>(i)].min().x(); };
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return left(a) < left(b); });
    Entries entries;
    std::vector<int> entered;
    for (const int i : order) {
        const Box2& box = boxes[static_cast<std::size_t>(i)];
        for (std::size_t strip = strips.of(box.min().y()); strip <= strips.of(box.max().y()); ++strip) {
            entered.push_back(static_cast<int>(strip));
            entries.boxes.push_back(i);
        }
    }
    entries.by_strip = Grouped(entered, strips.count());
    return entries;
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
    const Strips strips(boxes, std::clamp<std::size_t>(boxes.size() / kBoxesAStrip, 1, kMostStrips));
    const Entries entries = entriesOf(boxes, strips);
    std::vector<int> active;
    for (std::size_t strip = 0; strip < strips.count(); ++strip) {
        active.clear();
        for (const int entry : entries.by_strip[strip]) {
            const int i = entries.boxes[static_cast<std::size_t>(entry)];
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
