#pragma once

#include <vector>

#include "stepmill/planar/edge.h"

namespace stepmill::toolpath {

/// Flags of a loop's edges, not 0: needed, with stretches between two that are no longer than that needed as
/// well.
std::vector<char> bridged(const std::vector<Edge>& edges, const std::vector<char>& needed, double longest_mm);

/// The pieces of a loop that are needed; the loop itself where it is all round.
/// \param edges      the loop's, or parts of these, one after another
/// \param needed     of each edge, not 0: it is
/// \param bridge_mm  stretches between two that are needed, no longer than this, are gone along
std::vector<Path> neededPieces(const Loop& loop, const std::vector<Edge>& edges,
                               const std::vector<char>& needed, double bridge_mm);

}  // namespace stepmill::toolpath
