#pragma once

#include <vector>

#include "planar/clearance_diagram_graph.h"

namespace stepmill::clearance {

/// The part of an offset loop that belongs to one site, with points of larger clearance on its left.
struct Piece {
    int site = -1;
    OffsetCurve curve;
    bool forward = true;  ///< line: along the site; circle: counter-clockwise
    Vec2 from = Vec2::Zero();
    Vec2 to = Vec2::Zero();
    double rough_sweep = 0;  ///< on a full circle: angle swept, roughly; negative when run backwards [rad]
};

struct TracedLoop {
    std::vector<Piece> pieces;
    bool full_circle = false;  ///< one piece, a whole circle
};

/// Boundary of the set whose clearance exceeds the distance, on one side of the region's boundary.
///
/// \param tie_mm  a neck whose clearance is at most distance + tie_mm is closed
std::vector<TracedLoop> trace(const Graph& graph, Side side, double distance_mm, double tie_mm);

/// Shorter pieces are rounding [mm].
inline constexpr double kShort_mm = 3e-6;

/// Drops pieces that are rounding or run backwards, joins what is left on true curves and makes neighbours
/// on one curve one. A loop that vanishes has less than two pieces and is no full circle.
void tidy(TracedLoop& loop, const Graph& graph, Side side, double distance_mm);

/// Points on the nanometre grid; nothing for a loop too small to bound anything.
std::optional<Loop> toLoop(const TracedLoop& traced);

}  // namespace stepmill::clearance
