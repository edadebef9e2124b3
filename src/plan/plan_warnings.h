#pragma once

#include <string>
#include <vector>

#include "stepmill/layers/layer_stack.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// Adds warnings to others.
void append(std::vector<Warning>& warnings, const std::vector<Warning>& more);

/// Remarks of the import.
std::vector<Warning> remarksOf(const Part& part);
/// Doubts about the slicing.
std::vector<Warning> remarksOf(const LayerStack& layers);
/// Setups that the fixture file names and the plan does not have.
std::vector<Warning> unusedFixtures(const FixtureFile& given, const std::vector<PlannedSetup>& setups);
/// Steps that take much of a feature's time for little of its volume.
std::vector<Warning> slowSteps(const PlannedSetup& setup);

/// What a reader must know of a plan that is complete but for its warnings: what no setup plans, residuals
/// and allowances, how setups are held, slow steps, bending and travel by setup, what was planned with
/// caution, cycle times, the magazine, what of machine and material is assumed, parts that ask for more
/// than 2.5 axes, books that do not close.
/// \param largest_gap  PlanBooks::largest_gap
std::vector<Warning> warningsOf(const Plan& plan, const std::string& largest_gap, const Tolerances& tol);

}  // namespace stepmill
