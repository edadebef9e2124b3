// Single edges and pairs of them: the nearest point, parts, where they meet, how far apart they are.

#include "stepmill/planar/edge.h"

#include <algorithm>
#include <cmath>

#include "planar/intersection.h"
#include "planar/segment.h"

namespace stepmill {

namespace {

/// Parts of arcs shorter than so many steps of the grid are straight.
constexpr double kLeastArcGrids = 10;

/// Nearer to an arc's centre than rounding of computed points, a point has no direction from it [mm].
constexpr double kAtCentreMm = 3 * kGridMm;

/// Points of `a` where its distance to `b` can have a local minimum, ends aside: the foot of a centre on
/// a line, or the ends of the diameter that points at the other circle's centre.
void offerNormals(const Edge& a, const Edge& b, double& least) {
    if (!b.segment.arc) return;
    const Vec2 centre = b.segment.arc->centre;
    if (!a.segment.arc) {
        const Vec2 along = a.segment.to - a.from;
        const double square = along.squaredNorm();
        const double t = square > 0 ? along.dot(centre - a.from) / square : -1;
        if (t > 0 && t < 1) least = std::min(least, distanceTo(a.from + t * along, b));
        return;
    }
    const Arc& arc = *a.segment.arc;
    const Vec2 between = centre - arc.centre;
    if (between.norm() == 0) return;
    for (const double side : {1.0, -1.0}) {
        const Vec2 p = arc.centre + side * arc.radius_mm * between.normalized();
        if (distanceTo(p, a) <= kGridMm) least = std::min(least, distanceTo(p, b));
    }
}

/// The later end where both are equally near.
const Vec2& nearerEnd(const Edge& edge, const Vec2& p) {
    return (edge.from - p).norm() < (edge.segment.to - p).norm() ? edge.from : edge.segment.to;
}

}  // namespace

Edge makeEdge(const Vec2& from, const Segment& segment) {
    return {from, segment, planar::boundingBox(from, segment)};
}

Edge makeLine(const Vec2& from, const Vec2& to) {
    return makeEdge(from, {to, std::nullopt});
}

std::vector<Edge> edgesOf(const Path& path) {
    std::vector<Edge> edges;
    edges.reserve(path.segments.size());
    for (const auto& [from, segment] : eachEdge(path))
        edges.push_back(makeEdge(from, segment));
    return edges;
}

std::vector<Edge> edgesOf(const Region& region) {
    std::vector<Edge> edges;
    for (const Loop& loop : region.loops) {
        const std::vector<Edge> part = edgesOf(loop);
        edges.insert(edges.end(), part.begin(), part.end());
    }
    return edges;
}

Vec2 nearestPoint(const Edge& edge, const Vec2& p) {
    if (!edge.segment.arc) return edge.from + shareOf(edge, p) * (edge.segment.to - edge.from);
    const Arc& arc = *edge.segment.arc;
    const Vec2 out = p - arc.centre;
    const Vec2& end = nearerEnd(edge, p);
    if (out.norm() <= kAtCentreMm || !planar::inSweep(edge.from, edge.segment.to, arc, p)) return end;
    const bool foot_is_nearer = std::abs(out.norm() - arc.radius_mm) < (end - p).norm();
    return foot_is_nearer ? Vec2(arc.centre + arc.radius_mm * out.normalized()) : end;
}

double shareOf(const Edge& edge, const Vec2& p) {
    if (edge.from == edge.segment.to && !edge.segment.arc) return 0;
    return std::clamp(planar::shareOf(p, edge.from, edge.segment), 0.0, 1.0);
}

std::optional<Edge> cutOut(const Edge& edge, double from_share, double to_share) {
    if (to_share <= from_share) return std::nullopt;
    if (from_share <= 0 && to_share >= 1) return edge;
    const Vec2 from = snapToGrid(pointAt(edge, from_share));
    const Vec2 to = snapToGrid(pointAt(edge, to_share));
    if ((from - to).norm() < 0.5 * kGridMm) return std::nullopt;
    // Rounding may have turned the ends of so short an arc round: it would be all but a whole circle.
    const bool short_arc = (to_share - from_share) * length(edge) < kLeastArcGrids * kGridMm;
    return makeEdge(from, Segment{to, short_arc ? std::nullopt : edge.segment.arc});
}

std::vector<Vec2> meetingPoints(const Edge& a, const Edge& b) {
    if (!grown(a.box, kGridMm).intersects(b.box)) return {};
    std::vector<Vec2> points;
    for (const Vec2& p : planar::carrierIntersections(a.from, a.segment, b.from, b.segment, planar::kExactly))
        if (distanceTo(p, a) <= kGridMm && distanceTo(p, b) <= kGridMm) points.push_back(p);
    return points;
}

double separation(const Edge& a, const Edge& b) {
    if (!meetingPoints(a, b).empty()) return 0;
    double least = std::min({distanceTo(b.from, a), distanceTo(b.segment.to, a), distanceTo(a.from, b),
                             distanceTo(a.segment.to, b)});
    offerNormals(a, b, least);
    offerNormals(b, a, least);
    return least;
}

}  // namespace stepmill
