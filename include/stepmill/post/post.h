#pragma once

#include <string>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// The LinuxCNC program of one setup: header comments (part, setup, stock, work offset, tools), a safe
/// start line, operations in order with M6 and G43, arcs as G2/G3 with I and J, M30.
/// Metric, 4 decimals; every arc's centre agrees with both its ends within 1 um, so that no controller
/// refuses it.
/// \throws Error(Usage) if the plan's machine names a dialect there is no post for.
std::string program(const Plan& plan, const PlannedSetup& setup);

/// LinuxCNC tool table rows for the tools a setup uses.
std::string toolTable(const Plan& plan, const PlannedSetup& setup);

}  // namespace stepmill
