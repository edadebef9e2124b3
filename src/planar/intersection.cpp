// Where lines and arcs meet.

#include "planar/intersection.h"

#include <cmath>

#include "planar/segment.h"

namespace stepmill::planar {

namespace {

using Points = FewPoints;

/// Ends may lie off their arc's circle, and with it outside its box, by less than this [mm].
constexpr double kRoundedMm = 3 * kGridMm;

Points lineLine(const Vec2& from1, const Vec2& to1, const Vec2& from2, const Vec2& to2) {
    const Vec2 d1 = to1 - from1;
    const Vec2 d2 = to2 - from2;
    const double turn = cross(d1, d2);
    // Below this sine the crossing is lost in rounding, and lines of machine size coincide there anyway.
    if (std::abs(turn) <= 1e-10 * d1.norm() * d2.norm()) return {};
    return {from1 + d1 * (cross(from2 - from1, d2) / turn)};
}

Points lineCircle(const Vec2& from, const Vec2& to, const Arc& arc, const MeetingTolerance& tolerance) {
    if (from == to) return {};
    const Vec2 direction = (to - from).normalized();
    const Vec2 foot = from + direction * direction.dot(arc.centre - from);
    const double distance = (foot - arc.centre).norm();
    const double beyond = distance - arc.radius_mm;
    if (beyond > std::max(tolerance.reach_mm, tolerance.tangent_mm)) return {};
    if (beyond > -tolerance.tangent_mm) return {foot};
    const double half = std::sqrt((arc.radius_mm - distance) * (arc.radius_mm + distance));
    return {foot - half * direction, foot + half * direction};
}

Points circleCircle(const Arc& a, const Arc& b, const MeetingTolerance& tolerance) {
    const Vec2 between = b.centre - a.centre;
    const double d = between.norm();
    const double ra = a.radius_mm;
    const double rb = b.radius_mm;
    if (d + std::abs(ra - rb) <= tolerance.coincident_mm || d == 0) return {};
    const double apart = d - (ra + rb);
    const double inside = std::abs(ra - rb) - d;
    const double slack = std::max(tolerance.reach_mm, tolerance.tangent_mm);
    if (apart > slack || inside > slack) return {};
    const Vec2 axis = between / d;
    if (apart > -tolerance.tangent_mm) return {a.centre + axis * (ra + apart / 2)};
    if (inside > -tolerance.tangent_mm) {
        const double gap = inside / 2;
        return {ra > rb ? Vec2(a.centre + axis * (ra - gap)) : Vec2(a.centre - axis * (ra + gap))};
    }
    // Distance of the common chord from a's centre, and half its length.
    const double along = (d * d + (ra - rb) * (ra + rb)) / (2 * d);
    const double half = std::sqrt(std::max(0.0, (ra - along) * (ra + along)));
    const Vec2 across = leftOf(axis);
    return {a.centre + along * axis - half * across, a.centre + along * axis + half * across};
}

}  // namespace

Points carrierIntersections(const Vec2& from1, const Segment& segment1, const Vec2& from2,
                            const Segment& segment2, const MeetingTolerance& tolerance) {
    if (segment1.arc && segment2.arc) return circleCircle(*segment1.arc, *segment2.arc, tolerance);
    if (segment1.arc) return lineCircle(from2, segment2.to, *segment1.arc, tolerance);
    if (segment2.arc) return lineCircle(from1, segment1.to, *segment2.arc, tolerance);
    return lineLine(from1, segment1.to, from2, segment2.to);
}

Points contacts(const Edge& a, const Edge& b, double reach_mm) {
    Points points;
    const auto addEndsNear = [&](const Edge& edge, const Edge& other) {
        const Box2 around = grown(other.box, reach_mm + kRoundedMm);
        for (const Vec2& end : {edge.from, edge.to()})
            if (around.contains(end) && distanceTo(end, other) <= reach_mm) points.push_back(end);
    };
    addEndsNear(a, b);
    addEndsNear(b, a);
    // The touching point of curves that overlap by more than the reach would be out of reach of both.
    const MeetingTolerance tolerance{reach_mm, reach_mm, std::min(kTangentMm, reach_mm / 2)};
    for (const Vec2& p : carrierIntersections(a.from, a.segment, b.from, b.segment, tolerance))
        if (distanceTo(p, a) <= reach_mm && distanceTo(p, b) <= reach_mm) points.push_back(p);
    return points;
}

double distanceToCarrier(const Vec2& p, const Vec2& from, const Segment& segment) {
    if (segment.arc) return std::abs((p - segment.arc->centre).norm() - segment.arc->radius_mm);
    return std::abs(cross((segment.to - from).normalized(), p - from));
}

Vec2 projectOnCarrier(const Vec2& p, const Vec2& from, const Segment& segment) {
    if (segment.arc)
        return segment.arc->centre + segment.arc->radius_mm * (p - segment.arc->centre).normalized();
    const Vec2 direction = (segment.to - from).normalized();
    return from + direction * direction.dot(p - from);
}

}  // namespace stepmill::planar
