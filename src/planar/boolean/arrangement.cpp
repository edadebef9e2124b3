// Boundaries cut into pieces, and what is asked of a piece.

#include "planar/boolean/arrangement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "planar/segment.h"
#include "stepmill/core/units.h"

namespace stepmill::planar {

void appendCurves(const Loop& loop, int operand, int number, std::vector<Curve>& curves) {
    Vec2 from = loop.start;
    for (const Segment& segment : loop.segments) {
        const Vec2 to = segment.to;
        if (segment.arc && sweepsMoreThan(kPi + 1e-6, from, to, *segment.arc)) {
            const Segment half{snapToGrid(pointAt(from, segment, 0.5)), segment.arc};
            curves.push_back({makeEdge(from, half), operand, number});
            from = half.to;
        }
        curves.push_back({makeEdge(from, segment), operand, number});
        from = to;
    }
}

void appendCurves(const Region& region, int operand, std::vector<Curve>& curves) {
    int number = curves.empty() ? 0 : curves.back().loop + 1;
    for (const Loop& loop : region.loops)
        appendCurves(loop, operand, number++, curves);
}

Segment Arrangement::segment(const Piece& piece) const {
    Segment result{node(piece.end), std::nullopt};
    if (piece.straight) return result;
    result.arc = curves[static_cast<std::size_t>(piece.curve)].segment.arc;
    if (result.arc && !piece.along) result.arc->ccw = !result.arc->ccw;
    return result;
}

Segment Arrangement::onCurve(const Piece& piece) const {
    if (chord_mm == 0) return segment(piece);
    Segment result{place(piece.end), curves[static_cast<std::size_t>(piece.curve)].segment.arc};
    if (!result.arc) return result;
    if (!piece.along) result.arc->ccw = !result.arc->ccw;
    // Rounding can turn a short chord about the centre the wrong way.
    if (sweepsMoreThan(1.5 * kPi, place(piece.begin), result.to, *result.arc)) result.arc.reset();
    return result;
}

double Arrangement::lengthOf(const Piece& piece) const {
    return length(node(piece.begin), segment(piece));
}

void Arrangement::setCancelledApart() {
    const auto alive = [](const Piece& piece) { return piece.step != std::array<int, 2>{}; };
    const auto dead = std::stable_partition(pieces.begin(), pieces.end(), alive);
    cancelled.assign(dead, pieces.end());
    pieces.erase(dead, pieces.end());
}

}  // namespace stepmill::planar
