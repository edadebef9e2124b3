// Lines and arcs one by one: length, sweep, position, distance.

#include "planar/segment.h"

#include <algorithm>
#include <cmath>

#include "stepmill/core/units.h"

namespace stepmill {

namespace planar {

bool inSweep(const Vec2& from, const Vec2& to, const Arc& arc, const Vec2& p) {
    if (from == to) return true;
    Vec2 u = from - arc.centre;
    Vec2 v = to - arc.centre;
    const Vec2 w = p - arc.centre;
    if (!arc.ccw) std::swap(u, v);
    const double turn = cross(u, v);
    const bool at_most_half = turn > 0 || (turn == 0 && u.dot(v) < 0);
    if (at_most_half) return cross(u, w) >= 0 && cross(w, v) >= 0;
    return !(cross(v, w) > 0 && cross(w, u) > 0);
}

double shareOf(const Vec2& p, const Vec2& from, const Segment& segment) {
    if (!segment.arc) {
        const Vec2 d = segment.to - from;
        return d.dot(p - from) / d.squaredNorm();
    }
    const Arc& arc = *segment.arc;
    const double sweep = std::abs(sweepAngle(from, segment.to, arc));
    const Vec2 u = from - arc.centre;
    const Vec2 w = p - arc.centre;
    double turn = std::atan2(cross(u, w), u.dot(w));
    if (!arc.ccw) turn = -turn;
    // Angles just before the start count as negative, all others as passed on the way.
    if (turn < (sweep - 2 * kPi) / 2) turn += 2 * kPi;
    return turn / sweep;
}

int stepsForSweep(double sweep_rad, double radius_mm, double chord_mm) {
    // sagitta = r (1 - cos(step / 2)); never coarser than sixty degrees, so that a circle stays a shape.
    const double widest = kPi / 3;
    const double ratio = chord_mm / radius_mm;
    const double step = ratio >= 0.1 ? widest : std::min(widest, 2 * std::acos(1 - ratio));
    return std::max(1, static_cast<int>(std::ceil(std::abs(sweep_rad) / step - 1e-9)));
}

}  // namespace planar

using planar::cross;

double snapToGrid(double value_mm) {
    return std::round(value_mm / kGridMm) * kGridMm;
}

Vec2 snapToGrid(const Vec2& point) {
    return {snapToGrid(point.x()), snapToGrid(point.y())};
}

double sweepAngle(const Vec2& from, const Vec2& to, const Arc& arc) {
    if (from == to) return arc.ccw ? 2 * kPi : -2 * kPi;
    const Vec2 u = from - arc.centre;
    const Vec2 v = to - arc.centre;
    const double turn = std::atan2(cross(u, v), u.dot(v));
    if (arc.ccw) return turn > 0 ? turn : turn + 2 * kPi;
    return turn < 0 ? turn : turn - 2 * kPi;
}

double length(const Vec2& from, const Segment& segment) {
    if (!segment.arc) return (segment.to - from).norm();
    return segment.arc->radius_mm * std::abs(sweepAngle(from, segment.to, *segment.arc));
}

double length(const Path& path) {
    double sum = 0;
    Vec2 from = path.start;
    for (const Segment& segment : path.segments) {
        sum += length(from, segment);
        from = segment.to;
    }
    return sum;
}

Vec2 pointAt(const Vec2& from, const Segment& segment, double t) {
    if (t <= 0) return from;
    if (t >= 1) return segment.to;
    if (!segment.arc) return from + t * (segment.to - from);
    const Arc& arc = *segment.arc;
    const Vec2 u = from - arc.centre;
    const double angle = std::atan2(u.y(), u.x()) + t * sweepAngle(from, segment.to, arc);
    return arc.centre + arc.radius_mm * Vec2(std::cos(angle), std::sin(angle));
}

Vec2 tangentAt(const Vec2& from, const Segment& segment, double t) {
    if (!segment.arc) return (segment.to - from).normalized();
    const Vec2 u = (pointAt(from, segment, t) - segment.arc->centre).normalized();
    return segment.arc->ccw ? Vec2(-u.y(), u.x()) : Vec2(u.y(), -u.x());
}

double distanceTo(const Vec2& p, const Vec2& from, const Segment& segment) {
    if (segment.arc) {
        const Arc& arc = *segment.arc;
        const double ends = std::min((p - from).norm(), (p - segment.to).norm());
        if (!planar::inSweep(from, segment.to, arc, p)) return ends;
        return std::min(ends, std::abs((p - arc.centre).norm() - arc.radius_mm));
    }
    const Vec2 along = segment.to - from;
    const double squared = along.squaredNorm();
    const double t = squared > 0 ? std::clamp(along.dot(p - from) / squared, 0.0, 1.0) : 0.0;
    return (p - from - t * along).norm();
}

std::vector<Vec2> tessellate(const Path& path, double chord_mm) {
    std::vector<Vec2> points{path.start};
    Vec2 from = path.start;
    for (const Segment& segment : path.segments) {
        if (segment.arc) {
            const double sweep = sweepAngle(from, segment.to, *segment.arc);
            const int steps = planar::stepsForSweep(sweep, segment.arc->radius_mm, chord_mm);
            for (int i = 1; i < steps; ++i)
                points.push_back(pointAt(from, segment, static_cast<double>(i) / steps));
        }
        points.push_back(segment.to);
        from = segment.to;
    }
    return points;
}

}  // namespace stepmill
