#include "planar/clearance/loop_drawer.h"

#include "planar/segment.h"

namespace stepmill::clearance {

namespace {

/// Arcs shorter, or of smaller radius, lose their shape on the grid [mm].
constexpr double kShortMm = 4 * kGridMm;
constexpr double kLeastDrawnRadiusMm = 10 * kGridMm;
/// Joints farther apart get a line between them [mm].
constexpr double kBridgeMm = 1.5 * kGridMm;
/// Loops of less area, or thinner than this on average, are what rounding leaves of a loop without any.
constexpr double kNothingMm2 = 1e-9;
constexpr double kNothingMm = 2 * kGridMm;

/// Arcs that turn less [rad] do not come back to where they begin.
constexpr double kHardlyHalfTurn = 3;

bool isShort(const Vec2& from, const Vec2& to) {
    return (to - from).norm() <= kShortMm;
}

/// Do two lines run along each other, there and back?
bool turnsBack(const Vec2& from, const Vec2& corner, const Vec2& to) {
    const Vec2 ahead = corner - from, back = to - corner;
    return ahead.dot(back) < 0 &&
           std::abs(cross(ahead, back)) <= kGridMm * std::max(ahead.norm(), back.norm());
}

/// Has rounding put the end of an arc before its beginning? It would go nearly all the way round. Joints of
/// edges that are hardly longer than their rounding have normals by which far offsets differ so much.
bool runsBack(const Vec2& from, const Vec2& to, const Arc& arc, double sweep_rad) {
    const Vec2 first = from - arc.centre, last = to - arc.centre;
    const double drawn_rad = arc.ccw ? turnRad(first, last) : turnRad(last, first);
    return sweep_rad > 0 && sweep_rad < kHardlyHalfTurn && drawn_rad < 0;
}

/// Takes out a vertex that rounding has put beside its neighbour or at the tip of a spike. False when there
/// is none.
bool removeVertex(Loop& loop) {
    std::vector<Segment>& edges = loop.segments;
    const std::size_t count = edges.size();
    for (std::size_t i = 0; i < count && count > 2; ++i) {
        const std::size_t next = (i + 1) % count;
        if (edges[i].arc || edges[next].arc) continue;
        const Vec2 from = edges[(i + count - 1) % count].to;
        const Vec2 corner = edges[i].to, to = edges[next].to;
        if (!isShort(from, corner) && !isShort(corner, to) && !turnsBack(from, corner, to)) continue;
        edges[i].to = to;
        edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(next));
        const std::size_t merged = next == 0 ? edges.size() - 1 : i;
        if (to == from) edges.erase(edges.begin() + static_cast<std::ptrdiff_t>(merged));
        loop.start = edges.empty() ? to : edges.back().to;
        return true;
    }
    return false;
}

}  // namespace

void LoopDrawer::start(const Vec2& at) {
    loop_ = {snapToGrid(at), {}};
    last_edge_ = -1;
}

void LoopDrawer::lineTo(const Vec2& to, int edge) {
    const Vec2 point = snapToGrid(to);
    if (point == loop_.end()) return;
    loop_.segments.push_back({point, std::nullopt});
    last_edge_ = edge;
}

void LoopDrawer::bridgeTo(const Vec2& to) {
    if ((to - loop_.end()).norm() > kBridgeMm) lineTo(to, -1);
}

bool LoopDrawer::arcTo(const Vec2& to, const Arc& arc, double sweep_rad, int edge) {
    const Vec2 point = snapToGrid(to);
    const double length = std::abs(sweep_rad) * arc.radius_mm;
    if (length <= kShortMm || arc.radius_mm <= kLeastDrawnRadiusMm) {
        lineTo(point, edge);
        return false;
    }
    if (point == loop_.end() && std::abs(sweep_rad) < kHardlyHalfTurn) return false;
    if (runsBack(loop_.end(), point, arc, sweep_rad)) {
        lineTo(point, edge);
        return false;
    }
    const bool goes_on =
        !loop_.segments.empty() && loop_.segments.back().arc == arc && last_edge_ == edge && edge >= 0 &&
        point != (loop_.segments.size() > 1 ? loop_.segments[loop_.segments.size() - 2].to : loop_.start);
    if (goes_on)
        loop_.segments.back().to = point;
    else
        loop_.segments.push_back({point, arc});
    last_edge_ = edge;
    return true;
}

void LoopDrawer::closeInto(Region& region) {
    if (loop_.segments.empty()) return;
    if (!loop_.closed()) loop_.segments.push_back({loop_.start, std::nullopt});
    while (removeVertex(loop_)) {
    }
    const bool circle = loop_.segments.size() == 1 && loop_.segments[0].arc;
    if (loop_.segments.size() < 2 && !circle) return;
    Region drawn{{std::move(loop_)}};
    const double area_mm2 = std::abs(area(drawn));
    if (area_mm2 <= std::max(kNothingMm2, kNothingMm * perimeter(drawn) / 2)) return;
    region.loops.push_back(std::move(drawn.loops[0]));
}

}  // namespace stepmill::clearance
