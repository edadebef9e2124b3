// The ground that rectangles cover.

#include "layers/stock/rectangle_union.h"

#include <algorithm>
#include <map>
#include <utility>

namespace stepmill::layers {

namespace {

/// Ascending, those that follow a kept one within the distance dropped.
std::vector<double> parted(std::vector<double> values, double same_mm) {
    std::sort(values.begin(), values.end());
    std::vector<double> kept;
    for (const double value : values)
        if (kept.empty() || value > kept.back() + same_mm) kept.push_back(value);
    return kept;
}

/// The kept value that stands for it: the greatest not above.
std::size_t place(const std::vector<double>& kept, double value) {
    return static_cast<std::size_t>(std::upper_bound(kept.begin(), kept.end(), value) - kept.begin()) - 1;
}

using Corner = std::pair<double, double>;

/// Edges of an outline by their beginning; two begin where corners touch.
using Edges = std::multimap<Corner, Corner>;

Vec2 towards(const Corner& from, const Corner& to) {
    return Vec2(to.first - from.first, to.second - from.second);
}

/// Takes the edge that goes on from `at`; where corners touch the one that turns left, which stays with the
/// same rectangle.
Corner takeNext(Edges& edges, const Corner& at, const Vec2& heading) {
    const auto [first, last] = edges.equal_range(at);
    auto next = first;
    for (auto it = first; it != last; ++it)
        if (cross(heading, towards(at, it->second)) > 0) next = it;
    const Corner to = next->second;
    edges.erase(next);
    return to;
}

Loop traceLoop(Edges& edges) {
    const Corner begin = edges.begin()->first;
    std::vector<Corner> corners{begin};
    Vec2 heading = Vec2::Zero();
    for (Corner at = begin; corners.size() == 1 || at != begin;) {
        const Corner to = takeNext(edges, at, heading);
        const Vec2 next = towards(at, to);
        if (corners.size() > 1 && cross(heading, next) == 0) corners.pop_back();
        corners.push_back(to);
        heading = next;
        at = to;
    }
    // The least corner is a true one: an edge to the left or below would begin at a lesser one.
    Loop loop;
    loop.start = snapToGrid(Vec2(begin.first, begin.second));
    for (std::size_t i = 1; i < corners.size(); ++i)
        loop.segments.push_back({snapToGrid(Vec2(corners[i].first, corners[i].second)), std::nullopt});
    return loop;
}

}  // namespace

RectangleUnion::RectangleUnion(const std::vector<Box2>& boxes, double same_mm) {
    std::vector<double> levels;
    for (const Box2& box : boxes) {
        sides_.insert(sides_.end(), {box.min().x(), box.max().x()});
        levels.insert(levels.end(), {box.min().y(), box.max().y()});
    }
    sides_ = parted(std::move(sides_), same_mm);
    levels = parted(std::move(levels), same_mm);
    if (sides_.size() < 2) return;
    covered_.resize(sides_.size() - 1);
    for (const Box2& box : boxes) {
        const Stretch stretch{levels[place(levels, box.min().y())], levels[place(levels, box.max().y())]};
        if (stretch.low == stretch.high) continue;
        const std::size_t end = place(sides_, box.max().x());
        for (std::size_t i = place(sides_, box.min().x()); i < end; ++i)
            covered_[i].push_back(stretch);
    }
    for (std::vector<Stretch>& column : covered_) {
        std::sort(column.begin(), column.end(),
                  [](const Stretch& a, const Stretch& b) { return a.low < b.low; });
        std::vector<Stretch> joined;
        for (const Stretch& stretch : column) {
            if (joined.empty() || stretch.low > joined.back().high)
                joined.push_back(stretch);
            else
                joined.back().high = std::max(joined.back().high, stretch.high);
        }
        column = std::move(joined);
    }
}

std::vector<Box2> RectangleUnion::apart() const {
    std::vector<Box2> boxes;
    std::vector<std::size_t> before;  // boxes that end at the column, by rising height
    for (std::size_t i = 0; i < covered_.size(); ++i) {
        std::vector<std::size_t> now;
        auto from = before.begin();
        for (const Stretch& stretch : covered_[i]) {
            while (from != before.end() && boxes[*from].min().y() < stretch.low)
                ++from;
            const bool goes_on = from != before.end() && boxes[*from].min().y() == stretch.low &&
                                 boxes[*from].max().y() == stretch.high;
            if (goes_on) {
                boxes[*from].max().x() = sides_[i + 1];
                now.push_back(*from);
            } else {
                now.push_back(boxes.size());
                boxes.emplace_back(Vec2(sides_[i], stretch.low), Vec2(sides_[i + 1], stretch.high));
            }
        }
        before = std::move(now);
    }
    return boxes;
}

Region RectangleUnion::outline() const {
    Edges edges;
    for (std::size_t i = 0; i < covered_.size(); ++i)
        for (const Stretch& stretch : covered_[i]) {
            edges.insert({{sides_[i], stretch.low}, {sides_[i + 1], stretch.low}});
            edges.insert({{sides_[i + 1], stretch.high}, {sides_[i], stretch.high}});
        }
    // Along a side the boundary is where one of the columns beside it is covered and the other is not.
    static const std::vector<Stretch> kNothing;
    for (std::size_t i = 0; i < sides_.size(); ++i) {
        std::map<double, int> steps;  // +1: covered on the right from here on, -1: on the left
        const auto note = [&](const std::vector<Stretch>& column, int side) {
            for (const Stretch& stretch : column) {
                steps[stretch.low] += side;
                steps[stretch.high] -= side;
            }
        };
        note(i < covered_.size() ? covered_[i] : kNothing, 1);
        note(i > 0 ? covered_[i - 1] : kNothing, -1);
        int covered = 0;
        double from = 0;
        for (const auto& [y, step] : steps) {
            if (covered > 0) edges.insert({{sides_[i], y}, {sides_[i], from}});
            if (covered < 0) edges.insert({{sides_[i], from}, {sides_[i], y}});
            covered += step;
            from = y;
        }
    }
    Region region;
    while (!edges.empty())
        region.loops.push_back(traceLoop(edges));
    return region;
}

}  // namespace stepmill::layers
