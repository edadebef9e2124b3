// From a region's loops to sites.

#include <numbers>

#include "planar/clearance/site.h"
#include "planar/segment.h"

namespace stepmill::clearance {

namespace {

/// Normals that differ by less belong to a smooth joint: end points on the grid turn the tangents of short
/// arcs by that much. A disc of 100 mm then cuts half a nanometre [rad].
constexpr double kSmoothRad = 1e-4;
/// Turns closer than this to a half turn are cusps: the tangents do not tell their side [rad].
constexpr double kCuspRad = 1e-3;
/// Loops smaller than this are points: their edges are shorter than rounding lets one tell [mm].
constexpr double kSpeckMm = 2e-5;
/// Arcs of smaller radius are drawn straight [mm].
constexpr double kLeastSiteRadiusMm = 5e-6;

/// Edges no longer than this are left out: where a tangent arc leaves a line, Booleans may put a step of a
/// few grid points the wrong way round, and a disc beside it would leave the region [mm].
constexpr double kStepMm = 5 * kGridMm;

Site lineSite(const Vec2& from, const Vec2& to) {
    Site site;
    site.start = from;
    site.end = to;
    site.extent = (to - from).norm();
    site.direction = (to - from) / site.extent;
    site.normal = leftOf(site.direction);
    return site;
}

Site arcSite(const Arc& arc, const Vec2& from, const Vec2& to, double start_angle, double sweep) {
    Site site;
    site.kind = arc.ccw ? SiteKind::Concave : SiteKind::Convex;
    site.start = from;
    site.end = to;
    site.extent = std::abs(sweep);
    site.centre = arc.centre;
    site.radius = arc.radius_mm;
    site.start_angle = start_angle;
    site.turn = arc.ccw ? 1 : -1;
    site.first_ray = {std::cos(start_angle), std::sin(start_angle)};
    site.last_ray = {std::cos(start_angle + sweep), std::sin(start_angle + sweep)};
    return site;
}

Site cornerSite(const Vec2& at, double start_angle, double extent) {
    Site site = arcSite({at, 0, false}, at, at, start_angle, -extent);
    site.kind = SiteKind::Corner;
    return site;
}

/// The arc as one site, or two where it is longer than a half circle.
void appendArc(const Vec2& from, const Segment& segment, std::vector<Site>& sites) {
    const Arc& arc = *segment.arc;
    const Vec2 out = from - arc.centre;
    const double start_angle = std::atan2(out.y(), out.x());
    const double sweep = sweepAngle(from, segment.to, arc);
    if (std::abs(sweep) <= std::numbers::pi + 1e-6) {
        sites.push_back(arcSite(arc, from, segment.to, start_angle, sweep));
        return;
    }
    const Vec2 middle = pointAt(from, segment, 0.5);
    sites.push_back(arcSite(arc, from, middle, start_angle, sweep / 2));
    sites.push_back(arcSite(arc, middle, segment.to, start_angle + sweep / 2, sweep / 2));
}

bool negligible(const Vec2& from, const Segment& segment) {
    return (segment.to - from).norm() <= kStepMm && length(from, segment) <= 2 * kStepMm;
}

Vec2 travelAtStart(const Site& site) {
    return site.round() ? Vec2(site.turn * leftOf(site.first_ray)) : site.direction;
}

Vec2 travelAtEnd(const Site& site) {
    return site.round() ? Vec2(site.turn * leftOf(site.last_ray)) : site.direction;
}

/// Turn to the left at the joint of two neighbours.
double turnAt(const Site& before, const Site& after) {
    const double turn = turnRad(travelAtEnd(before), travelAtStart(after));
    if (std::abs(turn) < std::numbers::pi - kCuspRad) return turn;
    // Two edges that leave the joint side by side: a little farther on they lie apart.
    const auto lengthOf = [](const Site& s) { return s.round() ? s.extent * s.radius : s.extent; };
    const double step = std::min(lengthOf(before), lengthOf(after)) / 4;
    const auto at = [](const Site& s, double mm) {
        return contactAt(s, s.round() ? mm / s.radius : mm).foot;
    };
    const Vec2 from = at(before, lengthOf(before) - step);
    const Vec2 to = at(after, step);
    const double apart = turnRad(Vec2(from - before.end), Vec2(to - before.end));
    // Seen from the joint, free space lies clockwise from the edge that arrives to the one that leaves:
    // a cusp of free space where the way back is the shorter one.
    if (apart <= 0) return std::numbers::pi;
    return turn < 0 ? turn : -std::numbers::pi;
}

/// Joints of one loop: marks convex corners and smooth joints, puts reflex corners in between.
std::vector<Site> joined(std::vector<Site> edges) {
    std::vector<Site> loop;
    const std::size_t count = edges.size();
    for (std::size_t i = 0; i < count; ++i) {
        Site& before = edges[i];
        Site& after = edges[(i + 1) % count];
        const double turn = turnAt(before, after);
        before.sharp_end = after.sharp_start = turn > kSmoothRad;
        before.corner_end = after.corner_start = turn < -kSmoothRad;
    }
    for (std::size_t i = 0; i < count; ++i) {
        loop.push_back(edges[i]);
        if (!edges[i].corner_end) continue;
        const double turn = turnAt(edges[i], edges[(i + 1) % count]);
        const Vec2 normal = leftOf(travelAtEnd(edges[i]));
        loop.push_back(cornerSite(edges[i].end, std::atan2(normal.y(), normal.x()), -turn));
        loop.back().edge = edges[i].edge;
    }
    return loop;
}

/// A loop too small to tell its edges: as an obstacle a point, as a room nothing.
std::vector<Site> speck(const Loop& loop, const Box2& box) {
    if (signedArea(loop) > 0) return {};
    const Vec2 at = (box.min() + box.max()) / 2;
    return {cornerSite(at, 0, std::numbers::pi), cornerSite(at, -std::numbers::pi, std::numbers::pi)};
}

std::vector<Site> sitesOf(const Loop& loop, int first_edge) {
    const Box2 box = boundingBox(loop);
    if (box.sizes().maxCoeff() <= kSpeckMm) {
        std::vector<Site> sites = speck(loop, box);
        for (Site& site : sites)
            site.edge = first_edge;
        return sites;
    }
    std::vector<Site> edges;
    Vec2 from = loop.start;
    for (std::size_t k = 0; k < loop.segments.size(); ++k) {
        const Segment& segment = loop.segments[k];
        if (negligible(from, segment)) continue;
        const std::size_t first = edges.size();
        if (segment.arc && (segment.arc->radius_mm > kLeastSiteRadiusMm || from == segment.to))
            appendArc(from, segment, edges);
        else
            edges.push_back(lineSite(from, segment.to));
        for (std::size_t i = first; i < edges.size(); ++i)
            edges[i].edge = first_edge + static_cast<int>(k);
        from = segment.to;
    }
    return edges.size() < 2 ? std::vector<Site>() : joined(std::move(edges));
}

}  // namespace

std::vector<Site> makeSites(const Region& region, bool outside) {
    std::vector<Site> sites;
    int edges = 0, loops = 0;
    for (const Loop& loop : region.loops) {
        std::vector<Site> added = sitesOf(outside ? reversed(loop) : loop, edges);
        edges += static_cast<int>(loop.segments.size());
        if (added.empty()) continue;
        const int first = static_cast<int>(sites.size()), count = static_cast<int>(added.size());
        for (int i = 0; i < count; ++i) {
            added[i].loop = loops;
            added[i].previous = first + (i + count - 1) % count;
            added[i].next = first + (i + 1) % count;
        }
        sites.insert(sites.end(), added.begin(), added.end());
        ++loops;
    }
    return sites;
}

}  // namespace stepmill::clearance
