#pragma once

#include <array>
#include <functional>
#include <vector>

#include "planar/boolean/arrangement.h"

namespace stepmill::planar {

/// A piece with the winding numbers of both operands on its two sides.
struct LabelledPiece {
    Piece piece;
    std::array<int, 2> left{};
    std::array<int, 2> right{};
};

/// All pieces with what lies on their sides. O(pieces times chains between junctions).
std::vector<LabelledPiece> labelled(const Arrangement& arrangement);

/// Do the windings agree all around every junction? If not, snapping has pushed a piece across a node.
bool consistent(const Arrangement& arrangement, const std::vector<LabelledPiece>& labels);

/// The pieces between inside and outside, turned so that the inside is on their left.
/// `inside(windings of operand 0, of operand 1)` says which points belong to the result.
std::vector<Piece> boundary(const std::vector<LabelledPiece>& labels,
                            const std::function<bool(int, int)>& inside);

}  // namespace stepmill::planar
