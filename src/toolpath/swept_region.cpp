// The ground a disc sweeps: a box or a piece of ring along every edge, a disc at every corner.

#include "stepmill/toolpath/swept_region.h"

#include <cmath>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::toolpath {
namespace {

/// Corners that turn less than this need no disc of their own: the gap is some nanometres thin [rad].
constexpr double kNoDiscRad = 1e-6;
/// Arcs are cut into pieces no longer than this, so that none meets itself.
constexpr double kLongestSweepRad = kPi / 2;

void addLine(const Vec2& from, const Vec2& to, double radius_mm, std::vector<Region>& into) {
    const Vec2 left = leftOf((to - from).normalized()) * radius_mm;
    into.push_back(makePolygon({from - left, to - left, to + left, from + left}));
}

/// A quarter of a ring at most; down to the centre where the disc is wider than the arc.
void addArcPiece(const Arc& arc, double from_rad, double to_rad, double radius_mm,
                 std::vector<Region>& into) {
    const auto at = [&](double distance_mm, double angle_rad) {
        return snapToGrid(Vec2(arc.centre + distance_mm * Vec2(std::cos(angle_rad), std::sin(angle_rad))));
    };
    const double a = std::min(from_rad, to_rad);
    const double b = std::max(from_rad, to_rad);
    const Vec2 centre = snapToGrid(arc.centre);
    const double outer = snapToGrid(arc.radius_mm + radius_mm);
    const double inner = snapToGrid(arc.radius_mm - radius_mm);
    const Vec2 outer_a = at(outer, a);
    const Vec2 outer_b = at(outer, b);
    if ((outer_a - outer_b).norm() <= kGridMm) return;
    Loop loop{outer_a, {{outer_b, Arc{centre, outer, true}}}};
    const Vec2 inner_a = inner > 0 ? at(inner, a) : centre;
    const Vec2 inner_b = inner > 0 ? at(inner, b) : centre;
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

void addWay(const Path& way, double radius_mm, std::vector<Region>& into) {
    addDisc(way.start, radius_mm, into);
    Vec2 from = way.start;
    for (std::size_t i = 0; i < way.segments.size(); ++i) {
        const Segment& segment = way.segments[i];
        if (segment.arc) {
            addArc(from, segment, radius_mm, into);
        } else if (segment.to != from) {
            addLine(from, segment.to, radius_mm, into);
        }
        bool smooth = false;
        if (i + 1 < way.segments.size() && (segment.arc || segment.to != from)) {
            const Segment& next = way.segments[i + 1];
            if (next.arc || next.to != segment.to) {
                const Vec2 before = tangentAt(from, segment, 1);
                const Vec2 after = tangentAt(segment.to, next, 0);
                smooth = (before - after).norm() < kNoDiscRad;
            }
        }
        if (!smooth) addDisc(segment.to, radius_mm, into);
        from = segment.to;
    }
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

Region sweptRegion(const std::vector<Path>& ways, double radius_mm, const Tolerances& tol) {
    std::vector<Region> pieces;
    for (const Path& way : ways)
        addWay(way, radius_mm, pieces);
    return pieces.empty() ? Region{} : unite(pieces, tol);
}

}  // namespace stepmill::toolpath
