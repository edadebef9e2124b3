#pragma once

#include <optional>
#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// A stretch of boundary that rises and falls nowhere and turns back nowhere: at every height in its range
/// it has one place.
struct MonotonePiece {
    Vec2 from;
    Vec2 to;
    std::optional<Arc> arc;
    bool right_of_centre = false;  ///< which half of its circle

    double low() const { return std::min(from.y(), to.y()); }
    double high() const { return std::max(from.y(), to.y()); }
    double xAt(double y) const;
    double yAt(double x) const;
    /// Integral of x over y between two heights of the piece.
    double integralOfX(double low_y, double high_y) const;
};

/// The pieces of one edge: arcs are parted where they pass the outermost points of their circle.
void addPieces(const Vec2& from, const Segment& segment, std::vector<MonotonePiece>& into);
std::vector<MonotonePiece> piecesOf(const Region& region);

}  // namespace stepmill::layers
