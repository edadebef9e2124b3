// The ground a disc sweeps: a box or a piece of ring along every edge, a sector on the outside of every
// corner, a disc at every end. What is near the way is nearest to an edge, or to a corner from outside, or to
// an end.

#include "stepmill/toolpath/swept_region.h"

#include <cmath>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"

namespace stepmill::toolpath {
namespace {

/// Corners that turn less than this need no sector: the gap is some nanometres thin [rad].
constexpr double kNoSectorRad = 1e-6;
/// Corners that turn more get a whole disc.
constexpr double kLargestSectorRad = kPi / 2;
/// Sectors reach this far over the ends of the edges, where all is swept: no gap stays between them [rad].
constexpr double kSectorOverlapRad = 0.01;
/// Arcs are cut into pieces no longer than this, so that none meets itself.
constexpr double kLongestSweepRad = kPi / 2;

Vec2 pointAround(const Vec2& centre, double distance_mm, double angle_rad) {
    return snapToGrid(Vec2(centre + distance_mm * Vec2(std::cos(angle_rad), std::sin(angle_rad))));
}

void addLine(const Vec2& from, const Vec2& to, double radius_mm, std::vector<Region>& into) {
    const Vec2 left = leftOf((to - from).normalized()) * radius_mm;
    into.push_back(makePolygon({from - left, to - left, to + left, from + left}));
}

/// A quarter of a ring at most; down to the centre where the disc is wider than the arc.
void addArcPiece(const Arc& arc, double from_rad, double to_rad, double radius_mm,
                 std::vector<Region>& into) {
    const double a = std::min(from_rad, to_rad);
    const double b = std::max(from_rad, to_rad);
    const Vec2 centre = snapToGrid(arc.centre);
    const double outer = snapToGrid(arc.radius_mm + radius_mm);
    const double inner = snapToGrid(arc.radius_mm - radius_mm);
    const Vec2 outer_a = pointAround(arc.centre, outer, a);
    const Vec2 outer_b = pointAround(arc.centre, outer, b);
    if ((outer_a - outer_b).norm() <= kGridMm) return;
    Loop loop{outer_a, {{outer_b, Arc{centre, outer, true}}}};
    const Vec2 inner_a = inner > 0 ? pointAround(arc.centre, inner, a) : centre;
    const Vec2 inner_b = inner > 0 ? pointAround(arc.centre, inner, b) : centre;
    loop.segments.push_back({inner_b, std::nullopt});
    if (inner_a != inner_b) loop.segments.push_back({inner_a, Arc{centre, inner, false}});
    loop.segments.push_back({outer_a, std::nullopt});
    into.push_back({{loop}});
}

void addArc(const Vec2& from, const Segment& segment, double radius_mm, std::vector<Region>& into) {
    const Arc& arc = *segment.arc;
    const double sweep = sweepAngle(from, segment.to, arc);
    const Vec2 out = from - arc.centre;
    const double start = std::atan2(out.y(), out.x());
    const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / kLongestSweepRad - 1e-9)));
    for (int i = 0; i < pieces; ++i)
        addArcPiece(arc, start + sweep * i / pieces, start + sweep * (i + 1) / pieces, radius_mm, into);
}

void addDisc(const Vec2& at, double radius_mm, std::vector<Region>& into) {
    into.push_back(makeCircle(snapToGrid(at), snapToGrid(radius_mm)));
}

/// What is nearest to a corner where the way turns from one direction into another.
void addCorner(const Vec2& at, const Vec2& before, const Vec2& after, double radius_mm,
               std::vector<Region>& into) {
    const double turn_rad = std::atan2(cross(before, after), before.dot(after));
    if (std::abs(turn_rad) < kNoSectorRad) return;
    if (std::abs(turn_rad) > kLargestSectorRad) return addDisc(at, radius_mm, into);
    const double heading_rad = std::atan2(before.y(), before.x());
    const double first_rad = turn_rad > 0 ? heading_rad - kPi / 2 : heading_rad + turn_rad + kPi / 2;
    const Vec2 centre = snapToGrid(at);
    const double radius = snapToGrid(radius_mm);
    const Vec2 from = pointAround(centre, radius, first_rad - kSectorOverlapRad);
    const Vec2 to = pointAround(centre, radius, first_rad + std::abs(turn_rad) + kSectorOverlapRad);
    if (from == to || from == centre || to == centre) return addDisc(at, radius_mm, into);
    into.push_back(
        {{{centre, {{from, std::nullopt}, {to, Arc{centre, radius, true}}, {centre, std::nullopt}}}}});
}

void addWay(const Path& way, double radius_mm, std::vector<Region>& into) {
    addDisc(way.start, radius_mm, into);
    std::vector<Edge> edges = edgesOf(way);
    std::erase_if(edges, [](const Edge& edge) { return !edge.segment.arc && edge.from == edge.to(); });
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Edge& edge = edges[i];
        if (edge.segment.arc)
            addArc(edge.from, edge.segment, radius_mm, into);
        else
            addLine(edge.from, edge.to(), radius_mm, into);
        if (i + 1 < edges.size())
            addCorner(edge.to(), tangentAt(edge, 1), tangentAt(edges[i + 1], 0), radius_mm, into);
    }
    addDisc(way.end(), radius_mm, into);
}

std::vector<Region> sweptPieces(const std::vector<Path>& ways, double radius_mm) {
    std::vector<Region> pieces;
    for (const Path& way : ways)
        addWay(way, radius_mm, pieces);
    return pieces;
}

}  // namespace

std::vector<Region> piecesBeyondSkins(const Region& region, const Tolerances& tol) {
    constexpr double kThinSlivers = 2;
    std::vector<Region> pieces = components(region);
    std::erase_if(pieces, [&](const Region& piece) {
        const double mean_width_mm = 2 * area(piece) / perimeter(piece);
        return area(piece) <= tol.area_mm2 || mean_width_mm <= kThinSlivers * tol.sliver_mm;
    });
    return pieces;
}

Region beyondSkins(const Region& region, const Tolerances& tol) {
    Region all;
    for (const Region& piece : piecesBeyondSkins(region, tol))
        all.loops.insert(all.loops.end(), piece.loops.begin(), piece.loops.end());
    return all;
}

Region sweptRegion(const std::vector<Path>& ways, double radius_mm, const Tolerances& tol) {
    return unite(sweptPieces(ways, radius_mm), tol);
}

Region notSwept(const Region& region, const std::vector<Path>& ways, double radius_mm,
                const Tolerances& tol) {
    return subtract(region, sweptPieces(ways, radius_mm), tol);
}

}  // namespace stepmill::toolpath
