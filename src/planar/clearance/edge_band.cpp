#include "planar/clearance/edge_band.h"

#include <numbers>

#include "planar/segment.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"

namespace stepmill::clearance {

namespace {

/// Arcs are swept in pieces no longer than this, so that no loop comes round to itself [rad].
constexpr double kMostTurnRad = std::numbers::pi / 2;
/// Arcs of smaller radius lose their shape on the grid [mm].
constexpr double kLeastBandRadiusMm = 1e-5;
/// Edges shorter than this lie within a disc on their neighbours [mm].
constexpr double kShortEdgeMm = 2 * kGridMm;

Region loopOf(const Vec2& start, std::vector<Segment> segments) {
    Region region;
    region.loops.push_back({snapToGrid(start), std::move(segments)});
    for (Segment& segment : region.loops[0].segments)
        segment.to = snapToGrid(segment.to);
    return region;
}

/// A straight slot with round ends.
Region alongLine(const Vec2& from, const Vec2& to, double distance) {
    const Vec2 out = distance * leftOf((to - from).normalized());
    return loopOf(from - out, {{to - out, std::nullopt},
                               {to + out, Arc{to, distance, true}},
                               {from + out, std::nullopt},
                               {from - out, Arc{from, distance, true}}});
}

/// A bent slot with round ends, around `arc` counter-clockwise.
/// \pre arc.radius_mm > distance
Region alongArc(const Vec2& from, const Vec2& to, const Arc& arc, double distance) {
    const Vec2 out_from = distance * (from - arc.centre).normalized();
    const Vec2 out_to = distance * (to - arc.centre).normalized();
    return loopOf(from + out_from, {{to + out_to, Arc{arc.centre, arc.radius_mm + distance, true}},
                                    {to - out_to, Arc{to, distance, true}},
                                    {from - out_from, Arc{arc.centre, arc.radius_mm - distance, false}},
                                    {from + out_from, Arc{from, distance, true}}});
}

/// The wedge a disc that reaches the arc's centre sweeps between its two ends.
Region wedge(const Vec2& from, const Vec2& to, const Arc& arc, double distance) {
    const double radius = arc.radius_mm + distance;
    const Vec2 a = arc.centre + radius * (from - arc.centre).normalized();
    const Vec2 b = arc.centre + radius * (to - arc.centre).normalized();
    return loopOf(arc.centre,
                  {{a, std::nullopt}, {b, Arc{arc.centre, radius, true}}, {arc.centre, std::nullopt}});
}

void appendSwept(const Vec2& from, const Segment& segment, double distance, std::vector<Region>& swept) {
    if (!segment.arc) {
        if ((segment.to - from).norm() > kShortEdgeMm) swept.push_back(alongLine(from, segment.to, distance));
        return;
    }
    const double sweep = std::abs(sweepAngle(from, segment.to, *segment.arc));
    const int count = std::max(1, static_cast<int>(std::ceil(sweep / kMostTurnRad)));
    for (int k = 0; k < count; ++k) {
        Vec2 a = pointAt(from, segment, static_cast<double>(k) / count);
        Vec2 b = pointAt(from, segment, static_cast<double>(k + 1) / count);
        if ((a - b).norm() <= kShortEdgeMm) continue;
        if (!segment.arc->ccw) std::swap(a, b);
        if (segment.arc->radius_mm > distance + kLeastBandRadiusMm) {
            swept.push_back(alongArc(a, b, *segment.arc, distance));
            continue;
        }
        swept.push_back(wedge(a, b, *segment.arc, distance));
        swept.push_back(makeCircle(a, distance));
        swept.push_back(makeCircle(b, distance));
    }
}

}  // namespace

Region bandAround(const Region& region, double distance_mm, const Tolerances& tol) {
    std::vector<Region> swept;
    for (const Loop& loop : region.loops) {
        // A loop of nothing but short edges is a point.
        swept.push_back(makeCircle(loop.start, distance_mm));
        for (const auto& [from, segment] : eachEdge(loop))
            appendSwept(from, segment, distance_mm, swept);
    }
    return unite(swept, tol);
}

}  // namespace stepmill::clearance
