#include "access/entry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"

namespace stepmill::access {
namespace {

/// Distances between the material and a tool that goes down beside it, the best first [mm].
constexpr std::array<double, 3> kOpenEdgeClearanceMm{1.0, 0.25, 0.05};

/// Entries are tried at these shares of an edge's length, its middle first.
constexpr std::array<double, 7> kAlongEdge{0.5, 0.25, 0.75, 0.125, 0.875, 0.02, 0.98};

/// A helix whose radius is a larger share of the cutter's radius leaves a post in its middle.
constexpr double kWidestHelixShare = 0.9;
/// How small a way down may be, in cutter diameters: narrower helices and shorter ramps make the tool cut
/// with its centre, or leave a core under one that has no edges there.
struct LeastWays {
    double helix_radius;
    double ramp;
};
constexpr LeastWays kWithCore{0.15, 1.0};
/// With edges at the centre ways may be as small as still makes sense, for the cutter turns round at each
/// end.
constexpr LeastWays kCentreCutting{0.05, 0.1};
/// A ramp is tried along this many straight edges, the longest first,
constexpr std::size_t kRampEdges = 8;
/// and along this many evenly spaced directions, for components that have curved edges only.
constexpr int kRampFanDirections = 8;

/// All edges, the longest first; edges of equal length stay in loop order.
std::vector<Edge> edgesByLength(const Region& region) {
    std::vector<Edge> edges = edgesOf(region);
    std::stable_sort(edges.begin(), edges.end(),
                     [](const Edge& a, const Edge& b) { return length(a) > length(b); });
    return edges;
}

/// Unit direction out of the region, which lies on the edge's left.
Vec2 outward(const Edge& edge, double share) {
    return -leftOf(tangentAt(edge, share));
}

/// The entry beside the material, from where the tool moves in over an open edge.
///
/// Along an open edge the component ends where the disc just touches the target, at the distance r from it. A
/// disc one step farther out touches nothing.
std::optional<Entry> overOpenEdge(const FeatureGround& ground, double radius_mm,
                                  const std::vector<Edge>& edges) {
    const Tolerances& tol = ground.tolerances();
    const Feature& feature = ground.feature();
    const auto leavesTarget = [&](const Vec2& p) {
        return distanceToRegion(feature.target, p) >= radius_mm - tol.sliver_mm;
    };
    const auto clearOfWalls = [&](const Vec2& p) {
        return distanceToRegion(feature.obstruction, p) >= radius_mm + tol.guard_mm;
    };
    for (const double clearance_mm : kOpenEdgeClearanceMm) {
        for (const Edge& edge : edges) {
            if (!leavesTarget(pointAt(edge, 0.5))) continue;
            for (const double t : kAlongEdge) {
                const Vec2 rim = pointAt(edge, t);
                const Vec2 out = outward(edge, t) * clearance_mm;
                const Vec2 at = snapToGrid(Vec2(rim + out));
                if (distanceToRegion(feature.target, at) < radius_mm + clearance_mm / 2) continue;
                const bool free = clearOfWalls(rim) && clearOfWalls(rim + out / 2) && clearOfWalls(at);
                if (free) return Entry{EntryKind::OpenEdge, at, 0, Vec2::Zero()};
            }
        }
    }
    return std::nullopt;
}

/// The largest disc inside the component, which consists of axis positions.
std::optional<ClearanceDiagram::Disc> widestDisc(const FeatureGround& ground, double radius_mm,
                                                 const Region& component) {
    if (ground.walledIn()) {
        // The component is a part of the target shrunk by r. If it contains the centre of the target's widest
        // disc, that disc shrunk by r is the component's widest.
        const auto whole = ground.widestDiscInTarget();
        if (whole && whole->radius_mm > radius_mm && contains(component, whole->centre))
            return ClearanceDiagram::Disc{whole->centre, whole->radius_mm - radius_mm};
    }
    return ClearanceDiagram(component, ground.tolerances()).largestInscribedDisc();
}

/// The stretch of the line through `base` that lies in the component and contains `base`.
std::optional<Path> chordThrough(const Region& component, const Vec2& base, const Vec2& direction,
                                 const Tolerances& tol) {
    const double reach_mm = boundingBox(component).sizes().norm() + 1;
    const Vec2 from = snapToGrid(Vec2(base - direction * reach_mm));
    const Vec2 to = snapToGrid(Vec2(base + direction * reach_mm));
    for (const Path& piece : split(Path{from, {Segment{to, std::nullopt}}}, component, tol).inside) {
        const double start = (piece.start - base).dot(direction);
        const double end = (piece.end() - base).dot(direction);
        if (start <= 0 && end >= 0) return piece;
    }
    return std::nullopt;
}

/// The middle of the line across the component that starts at the edge's midpoint.
Vec2 middleBeside(const Region& component, const Edge& edge, const Tolerances& tol) {
    const Vec2 inward = -outward(edge, 0.5);
    const Vec2 foot = pointAt(edge, 0.5) + inward * tol.linear_mm * 2;
    const auto across = chordThrough(component, foot, inward, tol);
    return across ? Vec2((across->start + across->end()) / 2) : foot;
}

std::optional<Entry> ramp(const FeatureGround& ground, double shortest_mm, const Region& component,
                          const std::vector<Edge>& edges, const Vec2& middle) {
    const Tolerances& tol = ground.tolerances();
    std::optional<Path> longest;
    const auto consider = [&](const Vec2& base, const Vec2& direction) {
        const auto piece = chordThrough(component, base, direction, tol);
        if (piece && (!longest || length(*piece) > length(*longest) + tol.sliver_mm)) longest = piece;
    };
    std::size_t tried = 0;
    for (const Edge& edge : edges) {
        if (edge.segment.arc || length(edge) <= tol.sliver_mm) continue;
        if (tried++ == kRampEdges) break;
        const Vec2 along = (edge.segment.to - edge.from).normalized();
        consider(middle, along);
        consider(middleBeside(component, edge, tol), along);
    }
    for (int i = 0; i < kRampFanDirections; ++i) {
        const double angle_rad = kPi * i / kRampFanDirections;
        consider(middle, Vec2(std::cos(angle_rad), std::sin(angle_rad)));
    }
    if (!longest) return std::nullopt;
    // The ends keep a distance from the component's boundary: they must lie in the area that paths use, which
    // is smaller by the guard.
    const Vec2 along = (longest->end() - longest->start).normalized() * tol.sliver_mm;
    const Vec2 start = snapToGrid(Vec2(longest->start + along));
    const Vec2 end = snapToGrid(Vec2(longest->end() - along));
    if ((end - start).norm() < shortest_mm) return std::nullopt;
    return Entry{EntryKind::Ramp, start, 0, end};
}

}  // namespace

std::optional<Entry> findEntry(const FeatureGround& ground, const ToolAssembly& tool,
                               const Region& component) {
    const double radius_mm = tool.radius_mm();
    const std::vector<Edge> edges = edgesByLength(component);
    if (!ground.walledIn()) {
        if (const auto entry = overOpenEdge(ground, radius_mm, edges)) return entry;
    }
    const auto disc = widestDisc(ground, radius_mm, component);
    if (!disc) return std::nullopt;
    const double helix_mm =
        std::min(disc->radius_mm - ground.tolerances().sliver_mm, kWidestHelixShare * radius_mm);
    const LeastWays& least = tool.centre_cutting ? kCentreCutting : kWithCore;
    if (helix_mm >= least.helix_radius * tool.diameter_mm)
        return Entry{EntryKind::Helix, disc->centre, helix_mm, Vec2::Zero()};
    const double shortest_mm = least.ramp * tool.diameter_mm;
    if (const auto entry = ramp(ground, shortest_mm, component, edges, disc->centre)) return entry;
    if (tool.max_plunge_mm > 0) return Entry{EntryKind::Plunge, disc->centre, 0, Vec2::Zero()};
    return std::nullopt;
}

}  // namespace stepmill::access
