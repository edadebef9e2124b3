#pragma once

#include <string>
#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// What makes steps operations, beside the steps.
struct OperationSettings {
    const ToolLibrary& library;
    const Machine& machine;
    const std::string& material;
    const std::vector<EarlierSetup>& earlier;  ///< PlanRequest::earlier
    const Cautions& cautions;  ///< features whose mills get plain rapids, and whose bands wait for each other
    const Tolerances& tol;
};

/// The setups with the steps of all features as operations, in machining order and numbered in it; those of
/// an earlier plan keep their ids. The steps' paths move there.
std::vector<PlannedSetup> withOperations(std::vector<PlannedSetup> setups, const OperationSettings& settings);

/// "S1.O3": numbered in machining order from 1 on.
std::string operationId(const std::string& setup_id, std::size_t number);

/// Joins operations in their order: each begins with the rapid from where the one before it ended, so that
/// an operation's lengths and times are those of its part of the program. Not across a tool change, whose
/// way is part of its time.
void linkOperations(std::vector<Operation>& operations, const Machine& machine);

}  // namespace stepmill
