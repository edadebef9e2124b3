#include "access/walls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "stepmill/core/units.h"

namespace stepmill::access {
namespace {

/// Largest rounding error of a point computed from the walls, whose own points lie on the 1 nm grid [mm].
constexpr double kRoundingMm = 3e-6;
/// The clearance beside a neck is compared at this distance from it, as a share of the neck's width.
constexpr double kBesideShare = 0.02;

using PointPair = std::pair<Vec2, Vec2>;

/// Adds places along the stretch where two lines face each other, its middle first: one of them stands for a
/// pair of parallel walls.
void addMiddleOfOverlap(const Edge& a, const Edge& b, std::vector<PointPair>& pairs) {
    const Vec2 first = nearestPoint(a, b.from);
    const Vec2 last = nearestPoint(a, b.segment.to);
    if ((last - first).norm() <= kRoundingMm) return;  // end to end, or no overlap
    for (const double share : {0.5, 0.25, 0.75}) {
        const Vec2 p = first + share * (last - first);
        pairs.emplace_back(p, nearestPoint(b, p));
    }
}

/// Adds the points where the line through `towards` and the arc's centre meets the arc, each with the point
/// of the other edge nearest to it.
void addAlongCentre(const Edge& arc_edge, const Vec2& towards, const Edge& other,
                    std::vector<PointPair>& pairs) {
    const Arc& arc = *arc_edge.segment.arc;
    Vec2 u = towards - arc.centre;
    if (u.norm() <= kRoundingMm) u = pointAt(arc_edge, 0.5) - arc.centre;  // concentric
    u.normalize();
    for (const double side : {1.0, -1.0}) {
        const Vec2 p = arc.centre + side * arc.radius_mm * u;
        if (distanceTo(p, arc_edge) <= kRoundingMm) pairs.emplace_back(p, nearestPoint(other, p));
    }
}

/// Finds pairs of points, one on each edge, that include every pair at a local minimum of the distance.
/// \param middles  the middles of parallel lines only, which are sought first; else all pairs but these
void closePairs(const Edge& a, const Edge& b, bool middles, std::vector<PointPair>& pairs) {
    pairs.clear();
    if (middles) {
        if (!a.segment.arc && !b.segment.arc) addMiddleOfOverlap(a, b, pairs);
        return;
    }
    for (const auto& [edge, other] : {std::pair{&a, &b}, std::pair{&b, &a}}) {
        if (!edge->segment.arc) continue;
        const Vec2 towards =
            other->segment.arc ? other->segment.arc->centre : nearestPoint(*other, edge->segment.arc->centre);
        addAlongCentre(*edge, towards, *other, pairs);
    }
    for (const Vec2& end : {a.from, a.segment.to})
        pairs.emplace_back(end, nearestPoint(b, end));
    for (const Vec2& end : {b.from, b.segment.to})
        pairs.emplace_back(nearestPoint(a, end), end);
}

/// Is the disc between the two wall points a narrowest one? Between hollow walls clearance falls on both
/// sides of it, and the disc is the widest.
bool isNarrowest(const Walls& walls, const Vec2& p, const Vec2& q) {
    const Vec2 middle = (p + q) / 2;
    const double radius_mm = (p - q).norm() / 2;
    const Vec2 across = (q - p) / (2 * radius_mm);
    const Vec2 step = 2 * kBesideShare * radius_mm * leftOf(across);
    const double least_mm = radius_mm - kRoundingMm;
    return walls.clearance(middle + step) >= least_mm || walls.clearance(middle - step) >= least_mm;
}

bool before(const Neck& a, const Neck& b) {
    return std::tie(a.width_mm, a.at.y(), a.at.x()) < std::tie(b.width_mm, b.at.y(), b.at.x());
}

/// Is the neck in the list? Another place between the same parallel walls counts as the same neck: the
/// passage from one to the other has the same width all along.
bool known(const Walls& walls, const std::vector<Neck>& necks, const Neck& neck, double same_mm) {
    return std::any_of(necks.begin(), necks.end(), [&](const Neck& other) {
        if (std::abs(other.width_mm - neck.width_mm) > same_mm) return false;
        if ((other.at - neck.at).norm() <= same_mm) return true;
        for (const double share : {0.5, 0.25, 0.75}) {
            const Vec2 between = neck.at + share * (other.at - neck.at);
            if (std::abs(walls.clearance(between) - neck.width_mm / 2) > same_mm) return false;
        }
        return true;
    });
}

void addNecks(const Walls& walls, double widest_mm, bool middles, const Tolerances& tol,
              std::vector<Neck>& necks) {
    const std::vector<Edge>& edges = walls.edges();
    std::vector<PointPair> pairs;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        for (std::size_t j = i + 1; j < edges.size(); ++j) {
            if (edges[i].box.exteriorDistance(edges[j].box) > widest_mm) continue;
            closePairs(edges[i], edges[j], middles, pairs);
            for (const auto& [p, q] : pairs) {
                const Neck neck{(p - q).norm(), (p + q) / 2};
                if (neck.width_mm > widest_mm || neck.width_mm < 2 * tol.linear_mm) continue;
                if (!walls.discFits(neck.at, neck.width_mm / 2, kRoundingMm)) continue;
                if (!isNarrowest(walls, p, q) || known(walls, necks, neck, tol.linear_mm)) continue;
                necks.push_back(neck);
            }
        }
    }
}

}  // namespace

Walls::Walls(const FeatureGround& ground)
    : walled_in_(ground.walledIn()),
      target_(ground.feature().target),
      material_(ground.feature().obstruction),
      walls_(walled_in_ ? target_ : material_) {}

bool Walls::discFits(const Vec2& centre, double radius_mm, double slack_mm) const {
    if (walls_.anyNearer(centre, radius_mm - slack_mm)) return false;
    if (walled_in_) return contains(target_, centre);
    if (contains(material_, centre)) return false;
    return contains(target_, centre) || distanceToBoundary(target_, centre) < radius_mm - slack_mm;
}

std::vector<Arc> Walls::insideArcs() const {
    std::vector<Arc> arcs;
    for (const Edge& edge : walls_.edges()) {
        // The target lies left of its boundary, the room outside the obstruction right of its boundary.
        if (edge.segment.arc && edge.segment.arc->ccw == walled_in_) arcs.push_back(*edge.segment.arc);
    }
    return arcs;
}

std::vector<Neck> findNecks(const Walls& walls, double widest_mm, const Tolerances& tol) {
    std::vector<Neck> necks;
    addNecks(walls, widest_mm, true, tol, necks);
    addNecks(walls, widest_mm, false, tol, necks);
    std::sort(necks.begin(), necks.end(), before);
    return necks;
}

}  // namespace stepmill::access
