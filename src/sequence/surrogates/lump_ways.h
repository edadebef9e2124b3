#pragma once

#include <vector>

#include "stepmill/sequence/tool_dag.h"

namespace stepmill {

/// One way to clear a lump in the place of the tool whose holder is kept off it.
struct LumpWay {
    std::vector<int> tools;  ///< surrogates in the order of use, by rising number (falling diameter)
    double weight = 0;       ///< seconds or money of their paths, without tool changes
};

inline constexpr int kNoTool = -1;

/// What the lumps of one edge cost together.
struct ChosenWays {
    std::vector<int> ways;  ///< of each lump
    /// Paths, and one change for each tool that is used; kNoEdge: a lump has no way.
    double weight = kNoEdge;
    bool joins_next = false;  ///< the tool that follows is among them, comes last and is changed to once
};

/// The choice of one way per lump with the least sum of paths and tool changes, where a tool that works in
/// several lumps is called once, and for `next`, the tool that follows in the sequence, no change counts if
/// it can come last. Exact up to a number of combinations that no library of that many tools reaches in
/// practice; beyond it the best found until then. Ties go to the ways listed first.
/// O(product of the ways) at worst; with the bounds mostly the number of ways.
ChosenWays cheapestWays(const std::vector<std::vector<LumpWay>>& lumps, double change_weight,
                        int next = kNoTool);

}  // namespace stepmill
