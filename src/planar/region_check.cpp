// What is wrong with a region, in words.

#include <cmath>

#include <fmt/format.h>

#include "planar/boolean/arrangement.h"
#include "planar/boolean/windings.h"
#include "planar/intersection.h"
#include "planar/segment.h"
#include "stepmill/core/error.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill {

namespace {

using Trouble = std::optional<std::string>;

/// Rounding of an end point, of a centre and of a radius to the grid, and of the centre two arcs share.
constexpr double kOffCircleMm = 3 * kGridMm;

std::string text(const Vec2& p) {
    return fmt::format("({:.6f}, {:.6f})", p.x(), p.y());
}

bool finite(const Vec2& p) {
    return std::isfinite(p.x()) && std::isfinite(p.y());
}

Trouble diagnoseSegment(const Vec2& from, const Segment& segment) {
    if (!finite(segment.to)) return "an edge ends at no finite point";
    if (!segment.arc) {
        if (from != segment.to) return std::nullopt;
        return fmt::format("an edge of no length at {}", text(from));
    }
    const Arc& arc = *segment.arc;
    if (!finite(arc.centre) || !std::isfinite(arc.radius_mm) || arc.radius_mm <= 0)
        return fmt::format("the arc to {} has no positive radius or no centre", text(segment.to));
    for (const Vec2& end : {from, segment.to}) {
        const double off = (end - arc.centre).norm() - arc.radius_mm;
        if (std::abs(off) > kOffCircleMm)
            return fmt::format("the arc end {} lies {:.6f} mm off its circle, centre {} radius {:.6f}",
                               text(end), off, text(arc.centre), arc.radius_mm);
    }
    return std::nullopt;
}

/// Does the second edge run back over the first?
bool turnsBack(const Vec2& from, const Segment& first, const Segment& second) {
    if (first.arc.has_value() != second.arc.has_value()) return false;
    if (first.arc)
        return first.arc->centre == second.arc->centre && first.arc->radius_mm == second.arc->radius_mm &&
               first.arc->ccw != second.arc->ccw;
    const Vec2 ahead = first.to - from;
    const Vec2 back = second.to - first.to;
    return ahead.dot(back) < 0 &&
           std::abs(cross(ahead, back)) <= kGridMm * std::max(ahead.norm(), back.norm());
}

Trouble diagnoseLoop(const Loop& loop) {
    if (loop.segments.empty()) return "a loop without edges";
    if (!finite(loop.start)) return "a loop starts at no finite point";
    if (!loop.closed())
        return fmt::format("the loop from {} ends at {}: not closed", text(loop.start), text(loop.end()));
    Vec2 from = loop.start;
    for (std::size_t i = 0; i < loop.segments.size(); ++i) {
        if (auto trouble = diagnoseSegment(from, loop.segments[i])) return trouble;
        const Segment& next = loop.segments[(i + 1) % loop.segments.size()];
        if (loop.segments.size() > 1 && turnsBack(from, loop.segments[i], next))
            return fmt::format("the edge after {} runs back over the one before", text(loop.segments[i].to));
        from = loop.segments[i].to;
    }
    return std::nullopt;
}

/// Do two edges that lie on each other for a while part by a micrometre elsewhere? Then they touch there
/// and do not share a wall, however long the stretch is that two flat curves need to part.
bool partElsewhere(const planar::Curve& a, const planar::Curve& b) {
    constexpr double kApartMm = 1e-3;
    const auto leaves = [&](const planar::Curve& one, const planar::Curve& other) {
        for (const Vec2& p : {one.from, pointAt(one.from, one.segment, 0.5), one.segment.to})
            if (planar::distanceToCarrier(p, other.from, other.segment) > kApartMm) return true;
        return false;
    };
    return leaves(a, b) && leaves(b, a);
}

/// Every stretch of boundary must have the region, winding 1, on its left and nothing on its right.
/// Stretches no longer than `short_mm` are let off, and edges that run along each other for `touch_mm` or
/// that part from each other.
Trouble diagnoseCrossings(const std::vector<planar::Curve>& curves, double snap_mm, double short_mm,
                          double touch_mm) {
    const planar::Arrangement arrangement = planar::arrange(curves, snap_mm);
    std::vector<bool> clean(curves.empty() ? 0 : static_cast<std::size_t>(curves.back().loop) + 1, false);
    const std::vector<planar::LabelledPiece> pieces = planar::labelled(arrangement);
    const auto loopOf = [&](const planar::LabelledPiece& p) {
        return static_cast<std::size_t>(arrangement.curves[static_cast<std::size_t>(p.piece.curve)].loop);
    };
    const auto counts = [&](const planar::Piece& piece) { return arrangement.lengthOf(piece) > short_mm; };
    const auto along = [&](const planar::Piece& piece) {
        return fmt::format("two edges run along each other at {}", text(arrangement.node(piece.begin)));
    };
    const auto shareAWall = [&](const planar::Piece& piece) {
        if (arrangement.lengthOf(piece) <= touch_mm) return false;
        const auto curve = [&](int index) { return arrangement.curves[static_cast<std::size_t>(index)]; };
        return piece.twin < 0 || !partElsewhere(curve(piece.curve), curve(piece.twin));
    };
    for (const planar::Piece& piece : arrangement.cancelled)
        if (shareAWall(piece)) return along(piece);
    for (const auto& p : pieces) {
        if (p.piece.step[0] != 1 && shareAWall(p.piece)) return along(p.piece);
        if (p.left[0] == 1) clean[loopOf(p)] = true;
    }
    for (const auto& p : pieces) {
        if (p.left[0] == 1 || !counts(p.piece)) continue;
        const std::string where = text(arrangement.node(p.piece.begin));
        if (clean[loopOf(p)]) return fmt::format("edges cross at {}", where);
        if (p.left[0] > 1)
            return fmt::format("the counter-clockwise loop at {} lies inside another one", where);
        return fmt::format("the clockwise loop at {} lies outside all outer loops", where);
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> diagnose(const Region& region) {
    for (const Loop& loop : region.loops)
        if (auto trouble = diagnoseLoop(loop)) return trouble;
    std::vector<planar::Curve> curves;
    planar::appendCurves(region, 0, curves);
    // Loops that touch do so to within the tolerance of the boolean that made them. Touching corners may
    // overlap by a stretch of two such distances, one per loop. Arcs and lines that touch at small angles
    // overlap by far longer stretches, but no deeper: those are one stretch when points that close are
    // taken as one. Which distance shows that depends on what else is near, as it does in the booleans.
    constexpr double kTouchMm = 0.02;
    const double linear_mm = Tolerances().linear_mm;
    const double short_mm = 2 * linear_mm;
    const Trouble trouble = diagnoseCrossings(curves, kOffCircleMm, short_mm, short_mm);
    if (!trouble) return std::nullopt;
    for (const double snap_mm : {linear_mm, 0.3 * linear_mm})
        if (!diagnoseCrossings(curves, snap_mm, short_mm, kTouchMm)) return std::nullopt;
    return trouble;
}

void validate(const Region& region, const std::string& subject) {
    if (const auto trouble = diagnose(region)) throw Error(ErrorCode::InvalidRegion, subject, *trouble);
}

}  // namespace stepmill
