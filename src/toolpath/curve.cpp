// Lines and arcs against each other: where they meet, how far apart they are, parts of them.

#include "toolpath/curve.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stepmill::toolpath {

namespace {

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

double distance(const Edge& edge, const Vec2& p) {
    return distanceTo(p, edge.from, edge.segment);
}

void meetLines(const Edge& a, const Edge& b, std::vector<Vec2>& points) {
    const Vec2 u = a.segment.to - a.from;
    const Vec2 v = b.segment.to - b.from;
    const double turn = cross(u, v);
    if (turn == 0) return;
    points.push_back(a.from + cross(b.from - a.from, v) / turn * u);
}

void meetLineAndCircle(const Edge& line, const Arc& arc, std::vector<Vec2>& points) {
    const Vec2 along = line.segment.to - line.from;
    const double length_mm = along.norm();
    if (length_mm == 0) return;
    const Vec2 u = along / length_mm;
    const double foot = u.dot(arc.centre - line.from);
    const double height = cross(u, arc.centre - line.from);
    const double square = (arc.radius_mm - height) * (arc.radius_mm + height);
    if (square < 0) return;
    const double half = std::sqrt(square);
    points.push_back(line.from + (foot - half) * u);
    points.push_back(line.from + (foot + half) * u);
}

void meetCircles(const Arc& a, const Arc& b, std::vector<Vec2>& points) {
    const Vec2 between = b.centre - a.centre;
    const double d = between.norm();
    if (d == 0) return;
    const double along = (d + (a.radius_mm - b.radius_mm) * (a.radius_mm + b.radius_mm) / d) / 2;
    const double square = (a.radius_mm - along) * (a.radius_mm + along);
    if (square < 0) return;
    const Vec2 u = between / d;
    const Vec2 across = std::sqrt(square) * Vec2(-u.y(), u.x());
    points.push_back(a.centre + along * u + across);
    points.push_back(a.centre + along * u - across);
}

/// Points of `a` where its distance to `b` can have a local minimum, ends aside: the foot of a centre on
/// a line, or the ends of the diameter that points at the other circle's centre.
void offerNormals(const Edge& a, const Edge& b, double& least) {
    if (!b.segment.arc) return;
    const Vec2 centre = b.segment.arc->centre;
    if (!a.segment.arc) {
        const Vec2 along = a.segment.to - a.from;
        const double square = along.squaredNorm();
        const double t = square > 0 ? along.dot(centre - a.from) / square : -1;
        if (t > 0 && t < 1) least = std::min(least, distance(b, a.from + t * along));
        return;
    }
    const Arc& arc = *a.segment.arc;
    const Vec2 between = centre - arc.centre;
    if (between.norm() == 0) return;
    for (const double side : {1.0, -1.0}) {
        const Vec2 p = arc.centre + side * arc.radius_mm * between.normalized();
        if (distance(a, p) <= kGridMm) least = std::min(least, distance(b, p));
    }
}

double boxDistance(const Box2& a, const Box2& b) {
    const Vec2 gap = (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(0.0);
    return gap.norm();
}

}  // namespace

Edge makeEdge(const Vec2& from, const Segment& segment) {
    return {from, segment, boundingBox(Path{from, {segment}})};
}

std::vector<Edge> edgesOf(const Path& path) {
    std::vector<Edge> edges;
    edges.reserve(path.segments.size());
    Vec2 from = path.start;
    for (const Segment& segment : path.segments) {
        edges.push_back(makeEdge(from, segment));
        from = segment.to;
    }
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

std::vector<Vec2> meetingPoints(const Edge& a, const Edge& b) {
    if (!a.box.grown(kGridMm).overlaps(b.box)) return {};
    std::vector<Vec2> points;
    if (!a.segment.arc && !b.segment.arc) meetLines(a, b, points);
    if (!a.segment.arc && b.segment.arc) meetLineAndCircle(a, *b.segment.arc, points);
    if (a.segment.arc && !b.segment.arc) meetLineAndCircle(b, *a.segment.arc, points);
    if (a.segment.arc && b.segment.arc) meetCircles(*a.segment.arc, *b.segment.arc, points);
    std::erase_if(points,
                  [&](const Vec2& p) { return distance(a, p) > kGridMm || distance(b, p) > kGridMm; });
    return points;
}

double separation(const Edge& a, const Edge& b) {
    if (!meetingPoints(a, b).empty()) return 0;
    double least = std::min(
        {distance(a, b.from), distance(a, b.segment.to), distance(b, a.from), distance(b, a.segment.to)});
    offerNormals(a, b, least);
    offerNormals(b, a, least);
    return least;
}

bool anyNearer(const std::vector<Edge>& edges, const Edge& edge, double distance_mm) {
    return std::any_of(edges.begin(), edges.end(), [&](const Edge& other) {
        return boxDistance(other.box, edge.box) < distance_mm && separation(other, edge) < distance_mm;
    });
}

double shareOf(const Edge& edge, const Vec2& p) {
    if (edge.segment.arc) {
        if (p == edge.from) return 0;
        const double whole = sweepAngle(edge.from, edge.segment.to, *edge.segment.arc);
        const double part = sweepAngle(edge.from, p, *edge.segment.arc);
        // A point a rounding error before the start comes out as nearly a full turn.
        if (std::abs(part) > std::abs(whole))
            return (p - edge.from).squaredNorm() < (p - edge.segment.to).squaredNorm() ? 0 : 1;
        return part / whole;
    }
    const Vec2 along = edge.segment.to - edge.from;
    const double square = along.squaredNorm();
    return square > 0 ? std::clamp(along.dot(p - edge.from) / square, 0.0, 1.0) : 0.0;
}

std::optional<Edge> cutOut(const Edge& edge, double from_share, double to_share) {
    if (to_share <= from_share) return std::nullopt;
    if (from_share <= 0 && to_share >= 1) return edge;
    const Vec2 from = snapToGrid(pointAt(edge.from, edge.segment, from_share));
    const Vec2 to = snapToGrid(pointAt(edge.from, edge.segment, to_share));
    if ((from - to).norm() < 0.5 * kGridMm) return std::nullopt;
    return makeEdge(from, Segment{to, edge.segment.arc});
}

NearestPoint nearestOn(const Path& path, const Vec2& p) {
    NearestPoint best{(p - path.start).norm(), 0, 0.0, path.start};
    const std::vector<Edge> edges = edgesOf(path);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const double d = distance(edges[i], p);
        if (d >= best.distance_mm) continue;
        Vec2 on = edges[i].segment.to;
        if (edges[i].segment.arc) {
            const Arc& arc = *edges[i].segment.arc;
            const Vec2 q =
                p == arc.centre ? on : Vec2(arc.centre + arc.radius_mm * (p - arc.centre).normalized());
            on = distance(edges[i], q) <= kGridMm ? q : on;
            if (std::min((edges[i].from - p).norm(), (edges[i].segment.to - p).norm()) <= d)
                on = (edges[i].from - p).norm() <= (edges[i].segment.to - p).norm() ? edges[i].from
                                                                                    : edges[i].segment.to;
        } else {
            const Vec2 along = edges[i].segment.to - edges[i].from;
            on = edges[i].from + shareOf(edges[i], p) * along;
        }
        best = {d, i, shareOf(edges[i], on), snapToGrid(on)};
    }
    return best;
}

Path startingAt(const Path& closed, std::size_t edge, double share) {
    const std::vector<Edge> edges = edgesOf(closed);
    const std::optional<Edge> tail = cutOut(edges[edge], share, 1);
    const std::optional<Edge> head = tail ? cutOut(edges[edge], 0, share) : edges[edge];
    Path path{tail ? tail->from : edges[edge].segment.to, {}};
    if (!head) path.start = edges[edge].from;
    if (tail) path.segments.push_back(tail->segment);
    for (std::size_t i = 1; i < edges.size(); ++i)
        path.segments.push_back(edges[(edge + i) % edges.size()].segment);
    if (head) path.segments.push_back(head->segment);
    return path;
}

Path firstPart(const Path& path, double length_mm) {
    Path part{path.start, {}};
    double left = length_mm;
    for (const Edge& edge : edgesOf(path)) {
        const double whole = length(edge.from, edge.segment);
        if (whole < left) {
            part.segments.push_back(edge.segment);
            left -= whole;
            continue;
        }
        const std::optional<Edge> last = cutOut(edge, 0, left / whole);
        if (last) part.segments.push_back(last->segment);
        break;
    }
    return part;
}

double distanceToRegion(const Region& region, const Vec2& p) {
    return contains(region, p) ? 0.0 : distanceToBoundary(region, p);
}

}  // namespace stepmill::toolpath
