#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "planar/boolean/arrangement.h"
#include "planar/boolean/grouped.h"

namespace stepmill::planar {

/// The end of a piece at a node: where it begins, or where it comes in.
struct PieceEnd {
    const Piece* piece;
    bool leaves;
};

/// Indices of ends that share a node, counter-clockwise around it. Where two ends leave in nearly the
/// same direction, the further course of their pieces decides, along the length of the shorter one.
std::vector<std::size_t> counterClockwise(const Arrangement& arrangement, std::span<const PieceEnd> ends);

/// The ends of pieces by their nodes: number 2 i is where piece i begins, 2 i + 1 where it ends.
template <typename PieceOf>
Grouped endsByNode(std::size_t pieces, std::size_t nodes, const PieceOf& piece_of) {
    std::vector<int> node_of;
    node_of.reserve(2 * pieces);
    for (std::size_t i = 0; i < pieces; ++i) {
        node_of.push_back(piece_of(i).begin);
        node_of.push_back(piece_of(i).end);
    }
    return {node_of, nodes};
}

}  // namespace stepmill::planar
