#pragma once

#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// Setups with their times, and the sums of the plan.
struct TimedSetups {
    std::vector<PlannedSetup> setups;
    PlanTotals totals;
};

/// Times of every setup and of the plan; tool changes counted once a visit.
TimedSetups withTimes(std::vector<PlannedSetup> setups, const ToolLibrary& library, const Machine& machine);

}  // namespace stepmill
