// Lines, arcs and corners as a growing disc meets them.

#include "planar/clearance/site.h"

#include <numbers>

#include "planar/segment.h"

namespace stepmill::clearance {

namespace {

Vec2 ray(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

/// 1 - cos of the angle between two normals beyond which edges lie back to back: 143 degrees.
constexpr double kBackToBack = 1.8;

/// How high over the next edge beyond a convex corner rounding may put a foot [mm].
constexpr double kBesideMm = 5 * kTouchMm;

/// Clearance at which the disc reaches a point.
double stoppedByPoint(const Vec2& point, const Contact& contact) {
    const Vec2 w = point - contact.foot;
    const double approach = 2 * w.dot(contact.normal), distance2 = w.squaredNorm();
    if (approach <= 1e-15 * std::sqrt(distance2)) return distance2 < kTouchMm * kTouchMm ? 0 : kNever;
    return distance2 / approach;
}

/// A disc that touches the whole line or circle of a site at `touch`, which lies beyond one of its ends: what
/// does that end? `travel`: of the line or circle there.
Meeting meetingOfEnd(const Site& site, bool at_start, const Vec2& travel, const Vec2& touch,
                     const Contact& contact, const Site& own, const Meeting& carrier) {
    const Vec2& end = at_start ? site.start : site.end;
    if (at_start ? site.corner_start : site.corner_end) return {};
    if (end == own.start || end == own.end) {
        // Right beside a convex corner rounding may put the touch on the wrong side of the joint.
        const bool sharp = at_start ? site.sharp_start : site.sharp_end;
        const double towards = contact.normal.dot(travel) * (at_start ? 1 : -1);
        const double apart = (contact.foot - end).norm();
        const bool beside =
            towards > 0 && apart * towards < kBesideMm && (touch - end).norm() < 2 * apart + kTouchMm;
        return sharp && beside ? carrier : Meeting{};
    }
    return {stoppedByPoint(end, contact), kNever};
}

Meeting meetingOfLine(const Site& line, const Contact& contact, const Site& own) {
    // From the nearer end, so that heights close to a corner keep their digits.
    const Vec2 from_start = contact.foot - line.start;
    const Vec2 from_end = contact.foot - line.end;
    const bool nearer_start = from_start.squaredNorm() < from_end.squaredNorm();
    const double height = (nearer_start ? from_start : from_end).dot(line.normal);
    if (height < -kOverlapMm) return {};
    const double approach = (contact.normal - line.normal).squaredNorm() / 2;
    if (approach <= 1e-20) return {};
    const double clearance = std::max(height, 0.0) / approach;
    const Meeting meeting{clearance, height, approach > kBackToBack};
    const double sideways = clearance * contact.normal.dot(line.direction);
    const bool before_start = from_start.dot(line.direction) + sideways < 0;
    const bool after_end = from_end.dot(line.direction) + sideways > 0;
    if (!before_start && !after_end) return meeting;
    const Vec2 touch = contact.centreAt(clearance) - clearance * line.normal;
    return meetingOfEnd(line, before_start, line.direction, touch, contact, own, meeting);
}

Meeting meetingOfArc(const Site& arc, const Contact& contact, const Site& own) {
    const double side = arc.kind == SiteKind::Concave ? -1 : 1;
    const Vec2 w = contact.foot - arc.centre;
    const double distance = w.norm();
    const double height = side * (distance - arc.radius);
    if (height < -kOverlapMm) return {};
    const double approach = 2 * (arc.radius - side * w.dot(contact.normal));
    if (approach <= 1e-15 * arc.radius) return {};
    const double clearance = std::max(height, 0.0) * (distance + arc.radius) / approach;
    const bool back_to_back = 1 - side * w.dot(contact.normal) / distance > kBackToBack;
    const Meeting meeting{clearance, height, back_to_back};
    // A disc around the arc's own centre touches all of it.
    const Vec2 v = w + clearance * contact.normal;
    if (v.norm() <= 1e-12 * arc.radius) return meeting;
    const bool after_start = arc.turn * cross(arc.first_ray, v) >= 0;
    const bool before_end = arc.turn * cross(v, arc.last_ray) >= 0;
    if (after_start && before_end) return meeting;
    const Vec2 ray = v.normalized();
    const auto ofEnd = [&](bool at_start) {
        return meetingOfEnd(arc, at_start, arc.turn * leftOf(ray), arc.centre + arc.radius * ray, contact,
                            own, meeting);
    };
    if (before_end) return ofEnd(true);
    if (after_start) return ofEnd(false);
    const Meeting of_start = ofEnd(true), of_end = ofEnd(false);
    return of_start.clearance <= of_end.clearance ? of_start : of_end;
}

}  // namespace

Contact contactAt(const Site& site, double u) {
    if (!site.round()) {
        const double rest = site.extent - u;
        const Vec2 foot =
            u < rest ? Vec2(site.start + u * site.direction) : Vec2(site.end - rest * site.direction);
        return {foot, site.normal};
    }
    const Vec2 out = ray(site.start_angle + site.turn * u);
    return {site.centre + site.radius * out, site.kind == SiteKind::Concave ? Vec2(-out) : out};
}

double turnedTo(const Site& arc, const Vec2& ray_mm) {
    return arc.turn * turnRad(arc.first_ray, ray_mm);
}

double parameterOf(const Site& site, const Vec2& p) {
    if (!site.round()) return std::clamp((p - site.start).dot(site.direction), 0.0, site.extent);
    const Vec2 v = p - site.centre;
    const double turned = turnedTo(site, v);
    if (turned >= 0) return std::min(turned, site.extent);
    const double beyond = turned + 2 * std::numbers::pi - site.extent;
    return beyond < -turned ? site.extent : 0;
}

Meeting meetingOf(const Site& site, const Contact& contact, const Site& own) {
    switch (site.kind) {
        case SiteKind::Line:
            return meetingOfLine(site, contact, own);
        case SiteKind::Corner:
            return {stoppedByPoint(site.centre, contact), kNever};
        default:
            return meetingOfArc(site, contact, own);
    }
}

double distanceTo(const Site& site, const Vec2& p) {
    if (site.kind == SiteKind::Corner) return (p - site.centre).norm();
    if (site.kind == SiteKind::Line) {
        const double along = (p - site.start).dot(site.direction);
        if (along <= 0) return (p - site.start).norm();
        if (along >= site.extent) return (p - site.end).norm();
        return std::abs((p - site.start).dot(site.normal));
    }
    const Vec2 v = p - site.centre;
    const double turned = turnedTo(site, v);
    const bool facing = turned >= 0 && turned <= site.extent;
    if (facing) return std::abs(v.norm() - site.radius);
    return std::sqrt(std::min((p - site.start).squaredNorm(), (p - site.end).squaredNorm()));
}

Box2 boxOf(const Site& site) {
    Box2 box;
    box.extend(site.start);
    box.extend(site.end);
    if (site.kind == SiteKind::Concave || site.kind == SiteKind::Convex) {
        for (const Vec2& axis : {Vec2(1, 0), Vec2(0, 1), Vec2(-1, 0), Vec2(0, -1)}) {
            const double turned = turnedTo(site, axis);
            if (turned > 0 && turned < site.extent) box.extend(site.centre + site.radius * axis);
        }
    }
    return grown(box, 2 * kOverlapMm);
}

}  // namespace stepmill::clearance
