// Where true sites are equally near.

#include <Eigen/Dense>

#include "planar/clearance_diagram_graph.h"

namespace stepmill::clearance {

namespace {

// Equal distances may differ by the grid's rounding of end points, magnified where bisectors are flat.
constexpr double kEquidistant_mm = 1e-5;
constexpr double kConverged_mm = 1e-11;
constexpr double kResidual_mm = 3e-6;  // end points lie up to 1 nm off their arcs
constexpr int kMaxSteps = 30;

struct Pair {
    const Site* p;
    const Site* q;
    std::optional<Ray> ray;
};

Vec2 gradient(const Site& s, Side side, const Vec2& at) {
    if (s.kind == SiteKind::Line) return side == Side::Inside ? leftNormal(s.dir) : Vec2(-leftNormal(s.dir));
    const Vec2 r = at - s.centre;
    const double n = r.norm();
    constexpr double kAtCentre_mm = 1e-12;
    if (n < kAtCentre_mm) return Vec2::Zero();
    return s.concaveOn(side) ? Vec2(-r / n) : Vec2(r / n);
}

/// Sums of one Gauss-Newton step on the bisectors of neighbouring sites.
struct NormalEquations {
    Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
    Vec2 rhs = Vec2::Zero();
    double residual = 0;

    void add(const Vec2& gradient, double value) {
        normal += gradient * gradient.transpose();
        rhs -= gradient * value;
        residual = std::max(residual, std::abs(value));
    }
    void add(const Pair& pair, Side side, const Vec2& at) {
        const Site &p = *pair.p, &q = *pair.q;
        if (pair.ray) {
            const Vec2 tangent = leftNormal(pair.ray->normal);
            add(tangent, tangent.dot(at - pair.ray->from));
        } else if (p.concaveOn(side) && q.concaveOn(side) && p.centre == q.centre && p.radius == q.radius) {
            // Two arcs of one circle are equally near everywhere; apart from others only at its centre.
            add(Vec2::UnitX(), at.x() - p.centre.x());
            add(Vec2::UnitY(), at.y() - p.centre.y());
        } else {
            add(gradient(p, side, at) - gradient(q, side, at),
                signedDistance(p, side, at) - signedDistance(q, side, at));
        }
    }
};

}  // namespace

void settle(Vertex& vertex, const SiteSet& set, Side side, const std::vector<int>& sites, double chord_mm) {
    const auto site = [&](int k) -> const Site& { return set.sites[static_cast<std::size_t>(k)]; };
    const Vec2 start = vertex.point;
    if (sites.size() < 3) {
        const double a = distanceToSite(site(sites.front()), start),
                     b = distanceToSite(site(sites.back()), start);
        // Chords put the bisector of two sites that face each other off by part of a sagitta: one seems
        // nearer, the other farther. Neighbours pass on to each other smoothly.
        const bool neighbours = sharedNormal(set, sites.front(), sites.back(), side, start).has_value();
        vertex.clearance = neighbours ? std::min(a, b) : (a + b) / 2;
        return;
    }
    std::vector<Pair> pairs;
    double largest_radius = 0, rough = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < sites.size(); ++k) {
        const int p = sites[k], q = sites[(k + 1) % sites.size()];
        largest_radius = std::max(largest_radius, site(p).radius);
        rough = std::min(rough, distanceToSite(site(p), start));
        pairs.push_back({&site(p), &site(q), sharedNormal(set, p, q, side, start)});
    }
    vertex.clearance = rough;
    Vec2 at = start;
    double residual = 0;
    for (int step = 0; step < kMaxSteps; ++step) {
        NormalEquations equations;
        for (const Pair& pair : pairs)
            equations.add(pair, side, at);
        residual = equations.residual;
        const double trace = equations.normal.trace();
        if (trace <= 0) break;
        constexpr double kDamping = 1e-13;
        equations.normal.diagonal().array() += kDamping * trace;
        const Vec2 move = equations.normal.ldlt().solve(equations.rhs);
        at += move;
        if (residual < kConverged_mm || move.norm() < kConverged_mm) break;
    }
    double least = std::numeric_limits<double>::infinity(), most = 0, clearance = 0;
    for (const Pair& pair : pairs) {
        const double d = distanceToSite(*pair.p, at);
        least = std::min(least, d);
        most = std::max(most, d);
        if (pair.ray) clearance = pair.ray->normal.dot(at - pair.ray->from);
    }
    if (clearance <= 0) clearance = least;
    // Where a circle's centre is near, chords of one sagitta s shift a vertex by up to sqrt(2 R s).
    const double slack = 4 * std::max(chord_mm, set.unit_mm);
    const double reach = 12 * std::sqrt(2 * slack * std::max(largest_radius, rough)) + slack;
    if (residual > kResidual_mm || most - least > kEquidistant_mm || (at - start).norm() > reach) return;
    vertex.point = at;
    vertex.clearance = clearance;
}

}  // namespace stepmill::clearance
