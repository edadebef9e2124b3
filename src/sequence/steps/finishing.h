#pragma once

#include <string>
#include <vector>

#include "sequence/dag/evaluate_dag.h"

namespace stepmill {

/// The steps of a way through the tool DAG that leave an allowance, and after them those that take it off.
struct AllowanceSteps {
    /// Empty where the steps are to be made without allowance.
    std::vector<SequenceStep> steps;
    /// Why they leave less than was asked for; empty when they do not, or where none is called for: a drill
    /// makes its hole in one.
    std::string less;
};

/// The steps by `used`, in their order, with the allowance of the task's options.
///
/// Every tool works in the feature with its walls moved in and its floor raised by the allowance, and then
/// clears its own ground down to the floor; at last the last tool, which reaches all that the sequence does,
/// goes along the walls. The ground is the same as without allowance: where it would not be, or where some
/// cut of the last pass would be wider than kWidestFinishAllowances, walls get no allowance.
/// \throws Error(Internal) if a path gouges
/// \see docs/algorithms/finishing.md
AllowanceSteps stepsWithAllowance(const DagTask& task, const std::vector<const Candidate*>& used);

/// Finishing cuts are nowhere wider than this many allowances: in a corner of 40 degrees the strips along
/// both walls meet that wide.
inline constexpr double kWidestFinishAllowances = 3;

}  // namespace stepmill
