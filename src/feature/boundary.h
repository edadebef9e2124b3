#pragma once

#include <optional>
#include <vector>

#include "stepmill/feature/feature.h"

namespace stepmill::feature {

/// The target's loops cut into closed pieces, along the obstruction's boundary, and open ones. Outer loop
/// before holes; within a loop in its direction, each piece as long as it can be.
std::vector<BoundaryPiece> boundaryPieces(const Region& target, const Region& obstruction,
                                          const Tolerances& tol);

/// Smallest radius of the concave wall arcs; nothing where a closed piece has a sharp inner corner or no wall
/// is a concave arc.
std::optional<double> minCornerRadiusMm(const std::vector<BoundaryPiece>& boundary);

/// Do two closed edges anywhere meet in an inner corner without a radius?
bool hasSharpCorner(const std::vector<BoundaryPiece>& boundary);

}  // namespace stepmill::feature
