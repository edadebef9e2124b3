// From crossed faces to loops of lines and arcs.

#include "layers/section_path.h"

#include <Geom_CylindricalSurface.hxx>

#include "layers/curve_fit.h"
#include "layers/section_points.h"
#include "stepmill/core/units.h"

namespace stepmill::layers {

namespace {

/// Points closer than two grid steps are one.
constexpr double kJointMm = 2e-6;

double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

/// Line, circle or chain of points that a face shows at a height.
struct Curve {
    enum class Kind { Line, Circle, Points };
    Kind kind = Kind::Points;
    Vec2 normal = Vec2::Zero();  ///< unit, of a Line
    double offset = 0;
    Arc arc;          ///< of a Circle
    double turn = 0;  ///< angle the facets turn about the centre [rad]
    std::vector<Vec2> points;

    /// Signed distance from the line or circle.
    double distance(const Vec2& p) const {
        return kind == Kind::Line ? normal.dot(p) - offset : (p - arc.centre).norm() - arc.radius_mm;
    }
    Vec2 gradient(const Vec2& p) const {
        return kind == Kind::Line ? normal : Vec2((p - arc.centre).normalized());
    }
    Vec2 project(const Vec2& p) const {
        return kind == Kind::Points ? p : Vec2(p - distance(p) * gradient(p));
    }
};

/// Where a run begins and ends, on the true edges.
struct Ends {
    Vec2 from;
    Vec2 to;
};

Curve lineOf(const MeshFace& face, double z_mm) {
    Curve curve;
    curve.kind = Curve::Kind::Line;
    const double length = face.normal.head<2>().norm();
    curve.normal = face.normal.head<2>() / length;
    curve.offset = (face.offset_mm - face.normal.z() * z_mm) / length;
    return curve;
}

/// A lying cylinder shows a line on either side of its axis. Which one, the ends on the edges tell; a
/// loop cannot run over this face alone.
Curve lineOfLying(const FaceRun& run, const Ends& ends, double z_mm) {
    const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(run.face->surface);
    const gp_Pnt centre = cylinder->Location();
    const double dz = z_mm - centre.Z();
    const double half = std::sqrt(std::max(0.0, cylinder->Radius() * cylinder->Radius() - dz * dz));
    Curve curve;
    curve.kind = Curve::Kind::Line;
    curve.normal = Vec2(-run.face->axis.y(), run.face->axis.x());
    const double middle = curve.normal.dot(Vec2(centre.X(), centre.Y()));
    const double side_from = curve.normal.dot(ends.from) - middle;
    const double side_to = curve.normal.dot(ends.to) - middle;
    if (side_from * side_to < 0 && std::min(std::abs(side_from), std::abs(side_to)) > 0.5 * half) {
        // The ridge of the facets is a little lower than the cylinder's: a run that passes over it turns
        // back on the other side. Between its ends lies a strip thinner than the distance to the level.
        const Vec2 along = (ends.to - ends.from).normalized();
        curve.normal = Vec2(-along.y(), along.x());
        curve.offset = curve.normal.dot(ends.from);
        return curve;
    }
    const double side = side_from + side_to;
    curve.offset = middle + (side < 0 ? -half : half);
    return curve;
}

Curve circleOf(const FaceRun& run, double z_mm) {
    Curve curve;
    curve.kind = Curve::Kind::Circle;
    double distances = 0;
    for (const Crossing& c : run.crossings) {
        const Vec2 a = c.from - run.face->axis;
        const Vec2 b = c.to - run.face->axis;
        curve.turn += std::atan2(cross(a, b), a.dot(b));
        distances += (a.norm() + b.norm()) / 2;
    }
    const double mean = distances / static_cast<double>(run.crossings.size());
    curve.arc = {run.face->axis, snapToGrid(run.face->radiusAt(z_mm, mean)), curve.turn > 0};
    return curve;
}

Curve curveOf(const SolidMesh& mesh, const FaceRun& run, const Ends& ends, double z_mm) {
    if (run.face->kind == FaceKind::Plane) return lineOf(*run.face, z_mm);
    if (run.face->kind == FaceKind::Turned) return circleOf(run, z_mm);
    if (run.face->kind == FaceKind::Lying) return lineOfLying(run, ends, z_mm);
    Curve curve;
    curve.points = pointsOnSurface(mesh, run.crossings, z_mm);
    return curve;
}

/// Where two faces meet: the end of one curve and the start of the next, one point unless the solid's own
/// tolerances part them.
struct Joint {
    Vec2 end;
    Vec2 start;
};

/// Newton's method towards the common point of two lines or circles; where they touch rather than cross
/// the point on the edge is as good as any.
std::optional<Vec2> intersectNear(const Curve& a, const Curve& b, Vec2 p) {
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

Joint jointOf(const Curve& before, const Curve& after, const Vec2& on_edge) {
    const Vec2 end = before.project(on_edge);
    const Vec2 start = after.project(on_edge);
    if ((end - start).norm() <= kJointMm / 2 || before.kind == Curve::Kind::Points) {
        const Vec2 p = snapToGrid(start);
        return {p, p};
    }
    if (after.kind == Curve::Kind::Points) return {snapToGrid(end), snapToGrid(end)};
    if (const auto common = intersectNear(before, after, on_edge)) {
        const Vec2 p = snapToGrid(*common);
        return {p, p};
    }
    return {snapToGrid(end), snapToGrid(start)};
}

void appendCurve(const Curve& curve, const Vec2& from, const Vec2& to, double tolerance_mm,
                 std::vector<Segment>& out) {
    if (curve.kind == Curve::Kind::Line) {
        out.push_back({to, std::nullopt});
    } else if (curve.kind == Curve::Kind::Circle) {
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

Loop wholeLoop(const Curve& curve, double tolerance_mm) {
    if (curve.kind == Curve::Kind::Circle) {
        if (curve.arc.radius_mm < kJointMm) return {};
        const Loop circle = makeCircle(curve.arc.centre, curve.arc.radius_mm).loops.front();
        return curve.arc.ccw ? circle : reversed(circle);
    }
    if (curve.kind == Curve::Kind::Line || curve.points.size() < 4) return {};
    std::vector<Vec2> points = curve.points;
    points.front() = points.back() = snapToGrid(points.front());
    return tidyLoop(fitSafeSide(points, tolerance_mm));
}

bool sameCircle(const Arc& a, const Arc& b) {
    return a.ccw == b.ccw && (a.centre - b.centre).norm() <= kJointMm &&
           std::abs(a.radius_mm - b.radius_mm) <= kJointMm;
}

/// Can the two edges from `from` over `via` to `to` be one?
bool oneCurve(const Vec2& from, const Segment& first, const Segment& second) {
    if (first.arc.has_value() != second.arc.has_value()) return false;
    const Vec2& via = first.to;
    const Vec2& to = second.to;
    if (first.arc) {
        if (!sameCircle(*first.arc, *second.arc)) return false;
        return std::abs(sweepAngle(from, via, *first.arc) + sweepAngle(via, to, *second.arc)) <
               2 * kPi - 1e-6;
    }
    const Vec2 chord = to - from;
    const double length = chord.norm();
    if (length <= kJointMm || (via - from).dot(chord) <= 0 || (to - via).dot(chord) <= 0) return false;
    return std::abs(cross(chord, via - from)) <= kJointMm / 2 * length;
}

bool isNothing(const Vec2& from, const Segment& segment) {
    if ((segment.to - from).norm() > kJointMm) return false;
    return !segment.arc || std::abs(sweepAngle(from, segment.to, *segment.arc)) < kPi;
}

void dropNothings(std::vector<Segment>& segments) {
    std::vector<Segment> kept;
    for (const Segment& segment : segments) {
        if (!kept.empty() && isNothing(kept.back().to, segment)) continue;
        kept.push_back(segment);
    }
    // The joint of the last edge with the first: the first starts where the last ends.
    while (kept.size() > 1 && isNothing(kept.back().to, kept.front()))
        kept.erase(kept.begin());
    segments = std::move(kept);
}

void mergeNeighbours(std::vector<Segment>& segments) {
    bool changed = true;
    while (changed && segments.size() > 2) {
        changed = false;
        const std::size_t n = segments.size();
        for (std::size_t i = 0; i < n && !changed; ++i) {
            const Vec2 from = segments[(i + n - 1) % n].to;
            const std::size_t j = (i + 1) % n;
            if (!oneCurve(from, segments[i], segments[j])) continue;
            segments[i].to = segments[j].to;
            segments.erase(segments.begin() + static_cast<std::ptrdiff_t>(j));
            changed = true;
        }
    }
}

bool isCircle(const std::vector<Segment>& segments) {
    if (segments.empty() || !segments.front().arc) return false;
    for (const Segment& segment : segments)
        if (!segment.arc || !sameCircle(*segment.arc, *segments.front().arc)) return false;
    return true;
}

bool lessPoint(const Vec2& a, const Vec2& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
}

}  // namespace

Loop tidyLoop(std::vector<Segment> segments) {
    dropNothings(segments);
    mergeNeighbours(segments);
    if (isCircle(segments)) {
        const Arc& arc = *segments.front().arc;
        if (arc.radius_mm < kJointMm) return {};
        const Loop circle = makeCircle(arc.centre, arc.radius_mm).loops.front();
        return arc.ccw ? circle : reversed(circle);
    }
    if (segments.size() < 2) return {};
    const auto least = std::min_element(segments.begin(), segments.end(),
                                        [](const auto& a, const auto& b) { return lessPoint(a.to, b.to); });
    std::rotate(segments.begin(), least + 1, segments.end());
    Loop loop{segments.back().to, std::move(segments)};
    if (std::abs(signedArea(loop)) < kJointMm * length(loop)) return {};
    return loop;
}

Loop joinRuns(const SolidMesh& mesh, const std::vector<FaceRun>& runs, double z_mm, const Tolerances& tol) {
    if (runs.size() == 1 && runs.front().whole_loop)
        return wholeLoop(curveOf(mesh, runs.front(), {}, z_mm), tol.curve_fit_mm);
    const std::size_t n = runs.size();
    std::vector<Vec2> on_edge;  // point i lies between run i - 1 and run i
    for (const FaceRun& run : runs)
        on_edge.push_back(pointOnEdge(mesh, run.crossings.front().side_in, z_mm));
    std::vector<Curve> curves;
    for (std::size_t i = 0; i < n; ++i)
        curves.push_back(curveOf(mesh, runs[i], {on_edge[i], on_edge[(i + 1) % n]}, z_mm));
    std::vector<Joint> joints;
    for (std::size_t i = 0; i < n; ++i)
        joints.push_back(jointOf(curves[(i + n - 1) % n], curves[i], on_edge[i]));
    std::vector<Segment> segments;
    for (std::size_t i = 0; i < n; ++i) {
        const Joint& next = joints[(i + 1) % n];
        appendCurve(curves[i], joints[i].start, next.end, tol.curve_fit_mm, segments);
        if (next.start != next.end) segments.push_back({next.start, std::nullopt});
    }
    return tidyLoop(std::move(segments));
}

void sortLoops(Region& region) {
    std::stable_sort(region.loops.begin(), region.loops.end(), [](const Loop& a, const Loop& b) {
        const double area_a = signedArea(a);
        const double area_b = signedArea(b);
        if ((area_a > 0) != (area_b > 0)) return area_a > 0;
        return a.start != b.start ? lessPoint(a.start, b.start) : area_a < area_b;
    });
}

}  // namespace stepmill::layers
