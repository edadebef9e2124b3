#pragma once

#include <algorithm>

#include "stepmill/catalog/machine.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// Corners may be cut short by so much where the part itself is cut: as much as arcs may be off
/// (post/reader/arc.cpp) [mm].
inline constexpr double kFinishBlendMm = 0.02;
/// And so much where an allowance as thick stays on the walls [mm].
inline constexpr double kRoughBlendMm = 0.05;

/// How far a controller may leave the written path at corners in an operation: it never cuts more than the
/// allowance short, and without one no more than kFinishBlendMm.
inline double largestBlendMm(const FinishAllowance& leaves) {
    return std::clamp(leaves.walls_mm, kFinishBlendMm, kRoughBlendMm);
}

/// How far programs let it: as much as times count with, and where an allowance stays all of what is allowed.
inline double blendMm(const FinishAllowance& leaves, const Machine& machine) {
    const double largest_mm = largestBlendMm(leaves);
    return leaves.walls_mm > kFinishBlendMm ? largest_mm
                                            : std::min(machine.junction_deviation_mm, largest_mm);
}

}  // namespace stepmill
