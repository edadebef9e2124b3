// Curves joined to loops of lines and arcs.

#include "layers/section/plane_curve.h"

#include "layers/section/curve_fit.h"
#include "layers/section/tidy_loop.h"
#include "stepmill/core/units.h"

namespace stepmill::layers {

namespace {

/// Where two faces meet: the end of one curve and the start of the next, one point unless the solid's own
/// tolerances part them.
struct Joint {
    Vec2 end;
    Vec2 start;
};

/// Newton's method towards the common point of two lines or circles; where they touch rather than cross
/// the point on the edge is as good as any.
std::optional<Vec2> intersectNear(const PlaneCurve& a, const PlaneCurve& b, Vec2 p) {
    const Vec2 origin = p;
    const double reach = 0.05;  // no farther than edges may lie from their surfaces
    for (int i = 0; i < 8; ++i) {
        const Vec2 ga = a.gradient(p);
        const Vec2 gb = b.gradient(p);
        const double det = cross(ga, gb);
        if (std::abs(det) < 0.02) return std::nullopt;
        const double da = a.distance(p);
        const double db = b.distance(p);
        p -= Vec2(da * gb.y() - db * ga.y(), ga.x() * db - gb.x() * da) / det;
        if ((p - origin).norm() > reach) return std::nullopt;
    }
    return p;
}

Joint jointOf(const PlaneCurve& before, const PlaneCurve& after, const Vec2& on_edge) {
    const Vec2 end = before.project(on_edge);
    const Vec2 start = after.project(on_edge);
    if ((end - start).norm() <= kJointMm / 2 || before.kind == PlaneCurve::Kind::Points) {
        const Vec2 p = snapToGrid(start);
        return {p, p};
    }
    if (after.kind == PlaneCurve::Kind::Points) return {snapToGrid(end), snapToGrid(end)};
    if (const auto common = intersectNear(before, after, on_edge)) {
        const Vec2 p = snapToGrid(*common);
        return {p, p};
    }
    return {snapToGrid(end), snapToGrid(start)};
}

void appendCurve(const PlaneCurve& curve, const Vec2& from, const Vec2& to, double tolerance_mm,
                 std::vector<Segment>& out) {
    if (curve.kind == PlaneCurve::Kind::Line) {
        out.push_back({to, std::nullopt});
    } else if (curve.kind == PlaneCurve::Kind::Circle) {
        if (from == to && std::abs(curve.turn) < kPi) return;
        // Ends that rounding has swapped would turn a stretch of nothing into a whole circle.
        if (std::abs(sweepAngle(from, to, curve.arc) - curve.turn) > kPi) {
            out.push_back({to, std::nullopt});
            return;
        }
        out.push_back({to, curve.arc});
    } else {
        std::vector<Vec2> points = curve.points;
        points.front() = from;
        points.back() = to;
        for (const Segment& segment : fitSafeSide(points, tolerance_mm))
            out.push_back(segment);
    }
}

}  // namespace

Loop wholeLoop(const PlaneCurve& curve, double tolerance_mm) {
    if (curve.kind == PlaneCurve::Kind::Circle) {
        if (curve.arc.radius_mm < kJointMm) return {};
        const Loop circle = makeCircle(curve.arc.centre, curve.arc.radius_mm).loops.front();
        return curve.arc.ccw ? circle : reversed(circle);
    }
    if (curve.kind == PlaneCurve::Kind::Line || curve.points.size() < 4) return {};
    std::vector<Vec2> points = curve.points;
    points.front() = points.back() = snapToGrid(points.front());
    return tidyLoop(fitSafeSide(points, tolerance_mm));
}

Loop joinCurves(const std::vector<PlaneCurve>& curves, const std::vector<Vec2>& on_edge,
                double tolerance_mm) {
    const std::size_t n = curves.size();
    std::vector<Joint> joints;
    for (std::size_t i = 0; i < n; ++i)
        joints.push_back(jointOf(curves[(i + n - 1) % n], curves[i], on_edge[i]));
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < n; ++i) {
        const Joint& next = joints[(i + 1) % n];
        appendCurve(curves[i], joints[i].start, next.end, tolerance_mm, segments);
        if (next.start != next.end) segments.push_back({next.start, std::nullopt});
    }
    return tidyLoop(std::move(segments));
}

Path openPath(const PlaneCurve& curve, const Vec2& from, const Vec2& to, double tolerance_mm) {
    Path path{snapToGrid(curve.project(from)), {}};
    appendCurve(curve, path.start, snapToGrid(curve.project(to)), tolerance_mm, path.segments);
    return path;
}

}  // namespace stepmill::layers
