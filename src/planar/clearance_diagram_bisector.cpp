#include "planar/clearance_diagram_bisector.h"

namespace stepmill::clearance {

namespace {

constexpr double kSamePoint_mm = 1e-9;
constexpr double kParallel = 1e-12;

double sideSign(Side side) {
    return side == Side::Inside ? 1 : -1;
}

std::vector<Vec2> onAxis(const Site& site, const Axis& axis) {
    if (site.kind == SiteKind::Arc)
        return {site.centre + site.radius * axis.dir, site.centre - site.radius * axis.dir};
    return {footOn(site, axis.point)};
}

}  // namespace

std::optional<Axis> axisOf(const Site& p, const Site& q) {
    if (!p.round() && !q.round()) return std::nullopt;
    if (!p.round()) return Axis{q.centre, leftNormal(p.dir)};
    if (!q.round()) return Axis{p.centre, leftNormal(q.dir)};
    const Vec2 d = q.centre - p.centre;
    if (d.norm() < kSamePoint_mm) return std::nullopt;
    return Axis{p.centre, d.normalized()};
}

double signedDistance(const Site& site, Side side, const Vec2& p) {
    switch (site.kind) {
        case SiteKind::Line:
            return sideSign(side) * cross(site.dir, p - site.start);
        case SiteKind::Corner:
            return (p - site.centre).norm();
        case SiteKind::Arc: {
            const double d = (p - site.centre).norm();
            return site.concaveOn(side) ? site.radius - d : d - site.radius;
        }
    }
    return 0;
}

double distanceToSite(const Site& site, const Vec2& p) {
    if (site.kind == SiteKind::Corner) return (p - site.centre).norm();
    Segment segment{site.end, std::nullopt};
    if (site.kind == SiteKind::Arc) segment.arc = Arc{site.centre, site.radius, site.ccw};
    return distanceTo(p, site.start, segment);
}

Vec2 footOn(const Site& site, const Vec2& p) {
    if (site.kind == SiteKind::Line) return site.start + site.dir * site.dir.dot(p - site.start);
    if (site.kind == SiteKind::Corner) return site.centre;
    const Vec2 r = p - site.centre;
    const double n = r.norm();
    return n < kSamePoint_mm ? site.start : Vec2(site.centre + site.radius / n * r);
}

OffsetCurve offsetCurve(const Site& site, Side side, double distance) {
    OffsetCurve curve;
    curve.round = site.round();
    if (curve.round) {
        curve.point = site.centre;
        curve.radius = site.concaveOn(side) ? site.radius - distance : site.radius + distance;
    } else {
        curve.point = site.start + sideSign(side) * distance * leftNormal(site.dir);
        curve.dir = site.dir;
    }
    return curve;
}

Vec2 project(const OffsetCurve& curve, const Vec2& p) {
    if (!curve.round) return curve.point + curve.dir * curve.dir.dot(p - curve.point);
    const Vec2 r = p - curve.point;
    const double n = r.norm();
    return n < kSamePoint_mm ? p : Vec2(curve.point + curve.radius / n * r);
}

std::optional<Ray> sharedNormal(const SiteSet& set, int p, int q, Side side, const Vec2& near) {
    std::optional<Ray> best;
    double best_miss = 0;
    const auto consider = [&](const Joint& joint, const Vec2& tangent) {
        const Ray ray{joint.point, sideSign(side) * leftNormal(tangent)};
        const double miss = std::abs(cross(ray.normal, near - ray.from));
        if (!best || miss < best_miss) {
            best = ray;
            best_miss = miss;
        }
    };
    const auto scan = [&](int index, int other) {
        const Site& site = set.sites[static_cast<std::size_t>(index)];
        for (int j : {site.start_joint, site.end_joint}) {
            if (j < 0) continue;
            const Joint& joint = set.joints[static_cast<std::size_t>(j)];
            if (joint.corner >= 0 && joint.corner == other)
                consider(joint, joint.in == index ? joint.tangent_in : joint.tangent_out);
            else if (joint.corner < 0 && (joint.in == other || joint.out == other) && index < other)
                consider(joint, (joint.tangent_in + joint.tangent_out).normalized());
        }
    };
    scan(p, q);
    scan(q, p);
    return best;
}

std::vector<Vec2> criticalPoints(const Site& p, const Site& q, Side side) {
    const std::optional<Axis> axis = axisOf(p, q);
    if (!axis) return {};
    std::vector<Vec2> found;
    for (const Vec2& a : onAxis(p, *axis)) {
        for (const Vec2& b : onAxis(q, *axis)) {
            const Vec2 m = (a + b) / 2;
            const double c = (a - b).norm() / 2;
            const double tolerance = 1e-9 * (1 + c);
            if (c > tolerance && std::abs(signedDistance(p, side, m) - c) < tolerance &&
                std::abs(signedDistance(q, side, m) - c) < tolerance)
                found.push_back(m);
        }
    }
    return found;
}

std::optional<Vec2> equidistantPoint(const Site& p, const Site& q, Side side, double distance, const Vec2& a,
                                     const Vec2& b) {
    const OffsetCurve u = offsetCurve(p, side, distance), v = offsetCurve(q, side, distance);
    if (!u.round && !v.round) {
        const double det = cross(u.dir, v.dir);
        if (std::abs(det) < kParallel) return std::nullopt;
        return Vec2(u.point + u.dir * (cross(v.point - u.point, v.dir) / det));
    }
    if (u.round && v.round) {
        const Vec2 between = v.point - u.point;
        const double d = between.norm();
        if (d < kSamePoint_mm) return std::nullopt;
        const Vec2 axis = between / d;
        const double x = (d * d + (u.radius - v.radius) * (u.radius + v.radius)) / (2 * d);
        const double h = std::sqrt(std::max(0.0, (u.radius - x) * (u.radius + x)));
        const double sign = cross(axis, (a - u.point) + (b - u.point)) >= 0 ? 1 : -1;
        return Vec2(u.point + x * axis + sign * h * leftNormal(axis));
    }
    const OffsetCurve& line = u.round ? v : u;
    const OffsetCurve& circle = u.round ? u : v;
    const double off = cross(line.dir, circle.point - line.point);
    const double h = std::sqrt(std::max(0.0, (circle.radius - off) * (circle.radius + off)));
    const double sign = line.dir.dot((a - circle.point) + (b - circle.point)) >= 0 ? 1 : -1;
    return Vec2(circle.point - off * leftNormal(line.dir) + sign * h * line.dir);
}

}  // namespace stepmill::clearance
