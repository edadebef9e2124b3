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
    bool goes_round = false;  ///< circle: sweeps more than a right angle for sure
};

struct TracedLoop {
    std::vector<Piece> pieces;
    bool full_circle = false;  ///< one piece, a whole circle
};

/// Boundary of the set whose clearance exceeds the distance, on one side of the region's boundary.
///
/// \param tie_mm  a neck whose clearance is at most distance + tie_mm is closed
std::vector<TracedLoop> trace(const Graph& graph, Side side, double distance_mm, double tie_mm,
                              double chord_mm);

/// Are the middle and the joints of every piece at least distance - slack from the true sites of the pieces
/// beside it? Catches a topology that the chords got wrong.
bool keepsDistance(const Graph& graph, const std::vector<TracedLoop>& loops, double distance_mm,
                   double slack_mm);

/// Points on the nanometre grid; nothing for a loop too small to bound anything.
std::optional<Loop> toLoop(const TracedLoop& traced);

/// Middle of the piece.
Vec2 middle(const Piece& piece);

}  // namespace stepmill::clearance
