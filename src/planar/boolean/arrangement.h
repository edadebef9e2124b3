#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "stepmill/planar/edge.h"

namespace stepmill::planar {

/// Numbers of nodes, curves and pieces as containers want them.
inline std::size_t at(int index) {
    return static_cast<std::size_t>(index);
}

/// An edge of an operand as it came in.
struct Curve : Edge {
    int operand = 0;  ///< 0 or 1
    int loop = 0;     ///< numbered over both operands
};

/// A stretch of a curve between two nodes that no other piece crosses. Coinciding stretches of several
/// curves are one piece, named after the first.
struct Piece {
    int begin = 0;  ///< node
    int end = 0;    ///< node
    int curve = 0;
    bool along = true;      ///< runs in the direction of the curve
    bool straight = false;  ///< so short a part of an arc that it counts as a line
    /// How many more windings operand k has on the left of the piece than on its right.
    std::array<int, 2> step{};
    int twin = -1;  ///< another curve that coincides with it; the last one of several
};

/// All boundaries of two operands cut at each other's crossings.
struct Arrangement {
    std::vector<Curve> curves;
    std::vector<Vec2> nodes;
    /// Per node the corner for which it stands, before it was rounded to the grid of the chords. Empty when
    /// the pieces are the curves' own.
    std::vector<Vec2> places;
    std::vector<Piece> pieces;
    /// Stretches along which two curves run in opposite directions: they cancel and bound nothing.
    std::vector<Piece> cancelled;
    /// How far chords may lie off their curves [mm]; 0 when the pieces are the curves' own.
    double chord_mm = 0;

    const Vec2& node(int index) const { return nodes[static_cast<std::size_t>(index)]; }
    const Vec2& place(int index) const {
        return places.empty() ? node(index) : places[static_cast<std::size_t>(index)];
    }
    /// The piece as a segment from node(piece.begin).
    Segment segment(const Piece& piece) const;
    /// The piece as part of its line or arc again.
    Segment onCurve(const Piece& piece) const;
    double lengthOf(const Piece& piece) const;
    /// Moves the pieces that bound nothing to `cancelled`.
    void setCancelledApart();
};

/// The curves cut where they cross or touch.
///
/// Points nearer to each other than the snapping distance become one node. The node lies at the first of
/// them: corners come before crossings, operand 0 before operand 1.
Arrangement arrange(const std::vector<Curve>& curves, double snap_mm);

/// The same on chords, with GEOS' snap rounding: slower and true to `chord_mm` only, but the pieces
/// never contradict each other. Equal circles have equal chords; pieces keep the name of their curve.
Arrangement arrangeOnChords(const std::vector<Curve>& curves, double chord_mm);

/// The curves of a loop, which bear that number; arcs of more than a half circle are cut in two.
void appendCurves(const Loop& loop, int operand, int number, std::vector<Curve>& curves);
/// The curves of a region's loops, numbered on from the last one.
void appendCurves(const Region& region, int operand, std::vector<Curve>& curves);

}  // namespace stepmill::planar
