#include "sequence/dag/wall_lengths.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "stepmill/planar/indexed_region.h"

namespace stepmill {
namespace {

/// Ways nearer to a wall than this many slivers beyond the radius leave a sliver on the other side of a room
/// that is wider than the cutter.
constexpr double kOffSlivers = 2;

/// An edge of what must stay that has all of a target's edge on it.
bool isWall(const Edge& edge, const EdgeIndex& obstruction, const Tolerances& tol) {
    bool found = false;
    const Vec2 middle = pointAt(edge, 0.5);
    obstruction.forEachIn(grown(edge.box, tol.linear_mm), [&](const Edge& other) {
        const auto is_on = [&](const Vec2& p) { return distanceTo(p, other) <= tol.linear_mm; };
        found = found || (is_on(edge.from) && is_on(middle) && is_on(edge.to()));
    });
    return found;
}

bool isHollow(const Edge& wall) {
    return wall.segment.arc && wall.segment.arc->ccw;
}

/// The centre's way along a wall on its right; nothing inside a hollow that is too narrow.
std::optional<Edge> wayAlong(const Edge& wall, double distance_mm) {
    if (!wall.segment.arc) {
        const Vec2 by = distance_mm * leftOf((wall.to() - wall.from).normalized());
        return makeLine(wall.from + by, wall.to() + by);
    }
    const Arc& arc = *wall.segment.arc;
    const double radius_mm = arc.radius_mm + (arc.ccw ? -distance_mm : distance_mm);
    if (radius_mm <= kGridMm) return std::nullopt;
    const auto moved = [&](const Vec2& p) {
        return Vec2(arc.centre + radius_mm * (p - arc.centre).normalized());
    };
    return makeEdge(moved(wall.from), {moved(wall.to()), Arc{arc.centre, radius_mm, arc.ccw}});
}

struct Inside {
    double share = 0;  ///< of the way's length
    int stretches = 0;
};

Inside insideOf(const Edge& way, const IndexedRegion& region) {
    const std::vector<double> shares = sharesWhereMet(way, region.boundary());
    Inside inside;
    bool goes_on = false;
    for (std::size_t i = 1; i < shares.size(); ++i) {
        if (shares[i] <= shares[i - 1]) continue;
        const bool is_in = region.contains(pointAt(way, (shares[i - 1] + shares[i]) / 2));
        if (is_in) inside.share += shares[i] - shares[i - 1];
        if (is_in && !goes_on) ++inside.stretches;
        goes_on = is_in;
    }
    return inside;
}

}  // namespace

Walls::Walls(const Feature& feature, const Tolerances& tol) : tol_(tol) {
    const EdgeIndex obstruction(feature.obstruction);
    for (const Edge& edge : edgesOf(feature.target))
        if (isWall(edge, obstruction, tol)) walls_.push_back(edge);
}

WallLength Walls::touchedBy(const CutterArea& cutter) const {
    const IndexedRegion free(cutter.free_centres);
    const double r = cutter.radius_mm;
    // Where a stretch ends this much of it may be left: its sliver is thin enough.
    const double at_an_end_mm = std::sqrt(2 * r * tol_.sliver_mm);
    // In a slot as wide as the cutter one way touches both walls, and hardly any centre is free.
    const double in_slots = cutter.slot_middles.empty() ? 0 : 1;
    WallLength touched;
    for (const Edge& wall : walls_) {
        const double wall_mm = length(wall.from, wall.segment);
        const std::optional<Edge> near = wayAlong(wall, r + 2 * tol_.guard_mm);
        const std::optional<Edge> off = wayAlong(wall, r + kOffSlivers * tol_.sliver_mm);
        const Inside most = near ? insideOf(*near, free) : Inside{};
        const Inside least = off ? insideOf(*off, free) : Inside{};
        const double less_mm = 2 * at_an_end_mm * least.stretches;
        if (isHollow(wall)) {
            if (off)
                touched.hollow_least_mm +=
                    std::max(0.0, least.share * length(off->from, off->segment) - less_mm);
            continue;
        }
        touched.least_mm += std::max(0.0, least.share * wall_mm - less_mm);
        touched.most_mm += (std::max(most.share, least.share) + in_slots) * wall_mm +
                           2 * at_an_end_mm * std::max(most.stretches, least.stretches);
    }
    return touched;
}

}  // namespace stepmill
