#pragma once

#include <array>
#include <vector>

#include "planar/boolean/arrangement.h"

namespace stepmill::planar {

/// A loop of an operand as it came in.
struct OperandLoop {
    const Loop* loop;
    int operand = 0;  ///< 0 or 1
};

/// Loops that meet, directly or over others. No other loop comes near them, so all others wind the same
/// number of times around each of their points.
struct LoopGroup {
    std::vector<OperandLoop> loops;
    std::array<int, 2> around{};  ///< windings of all other loops, by operand
};

/// The loops in groups: each group is a Boolean of its own, and mostly few loops are in one with others.
/// \param apart_mm  loops that come no nearer than that do not meet
/// \note O(n log n) for n edges of which few are near each other
std::vector<LoopGroup> loopGroups(const std::vector<OperandLoop>& loops, double apart_mm);

/// Would a Boolean of the loop alone give the very same loop? Then it has no edge to merge, to shorten or to
/// leave out, comes nowhere within `apart_mm` of itself and is wider than `thin_mm`.
bool isTidy(const OperandLoop& loop, double apart_mm, double thin_mm);

}  // namespace stepmill::planar
