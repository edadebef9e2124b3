// Lines and arcs one by one: length, sweep, position, distance.

#include "planar/segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"

namespace stepmill {

namespace planar {

namespace {

/// On which side of a-b lies p: +1 left, -1 right. A point on the line counts as if moved to the right by
/// a little and upwards by much less, so that it is on one side only, and the same for every caller.
int sideOf(const Vec2& a, const Vec2& b, const Vec2& p) {
    const double left = cross(b - a, p - a);
    if (left != 0) return left > 0 ? 1 : -1;
    const double dy = b.y() - a.y();
    if (dy != 0) return dy > 0 ? -1 : 1;
    return b.x() > a.x() ? 1 : -1;
}

/// Is p, a point of the circle's disc, between the arc and its chord?
bool betweenChordAndArc(const Vec2& from, const Vec2& to, const Arc& arc, const Vec2& p, bool arc_side) {
    // Ends that rounding moved off the circle turn the chord of a short arc so far that its line cuts off
    // another part of the disc. The cone from the centre tells the parts apart.
    if ((to - from).squaredNorm() >= arc.radius_mm * arc.radius_mm) return arc_side;
    const double turn = cross(from - arc.centre, to - arc.centre);
    const bool short_way = (turn > 0) == arc.ccw;
    const bool in_cone = inSweep(from, to, arc, p);
    return short_way ? arc_side && in_cone : arc_side || in_cone;
}

}  // namespace

int windingShare(const Vec2& from, const Segment& segment, const Vec2& p, int side) {
    // A ray from p along +x counts the chord; points between chord and arc have one turn more.
    const Vec2& to = segment.to;
    const bool spans = (from.y() <= p.y()) != (to.y() <= p.y());
    if (!segment.arc) {
        if (!spans) return 0;
        const int chord_side = side != 0 ? side : sideOf(from, to, p);
        return (to.y() > p.y()) == (chord_side > 0) ? chord_side : 0;
    }
    const Arc& arc = *segment.arc;
    const int turn = arc.ccw ? 1 : -1;
    const bool in_disc =
        side != 0 ? side == turn : (p - arc.centre).squaredNorm() < arc.radius_mm * arc.radius_mm;
    if (from == to) return in_disc ? turn : 0;
    if (!spans && !in_disc) return 0;
    // Left turning arcs bulge to the right of their chord, and so does their middle.
    const int chord_side = side != 0 ? -turn : sideOf(from, to, p);
    const bool arc_side = chord_side == -turn;
    int share = spans && (to.y() > p.y()) == (chord_side > 0) ? chord_side : 0;
    if (in_disc && (side != 0 || betweenChordAndArc(from, to, arc, p, arc_side))) share += turn;
    return share;
}

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

bool sweepsMoreThan(double least_rad, const Vec2& from, const Vec2& to, const Arc& arc) {
    const double turn = cross(from - arc.centre, to - arc.centre);
    if (from != to && (arc.ccw ? turn > 0 : turn < 0)) return false;
    return std::abs(sweepAngle(from, to, arc)) > least_rad;
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
    double turn = turnRad(u, w);
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
    const double turn = turnRad(u, v);
    if (arc.ccw) return turn > 0 ? turn : turn + 2 * kPi;
    return turn < 0 ? turn : turn - 2 * kPi;
}

double length(const Vec2& from, const Segment& segment) {
    if (!segment.arc) return (segment.to - from).norm();
    return segment.arc->radius_mm * std::abs(sweepAngle(from, segment.to, *segment.arc));
}

double length(const Path& path) {
    double sum = 0;
    for (const auto& [from, segment] : eachEdge(path))
        sum += length(from, segment);
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
    return segment.arc->ccw ? leftOf(u) : -leftOf(u);
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

double distanceTo(const Vec2& p, const Path& path) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [from, segment] : eachEdge(path))
        least = std::min(least, distanceTo(p, from, segment));
    return least;
}

std::vector<Vec2> tessellate(const Path& path, double chord_mm) {
    std::vector<Vec2> points{path.start};
    for (const auto& [from, segment] : eachEdge(path)) {
        if (segment.arc) {
            const double sweep = sweepAngle(from, segment.to, *segment.arc);
            const int steps = planar::stepsForSweep(sweep, segment.arc->radius_mm, chord_mm);
            for (int i = 1; i < steps; ++i)
                points.push_back(pointAt(from, segment, static_cast<double>(i) / steps));
        }
        points.push_back(segment.to);
    }
    return points;
}

}  // namespace stepmill
