#pragma once

#include <vector>

#include "plan/feature_planner.h"
#include "stepmill/plan/hole_wishes.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// Setups whose holes are tapped as the hole table asks.
struct ThreadedSetups {
    std::vector<PlannedSetup> setups;
    int missing = 0;  ///< holes that no tap of the library can tap
    std::vector<Warning> warnings;
};

/// Puts a tapping step behind the others of every hole that is to be tapped, of the tap that takes least
/// time. A thread takes nothing of the part's volume, so the books stay. \pre the steps still have their
/// paths
ThreadedSetups withThreads(std::vector<PlannedSetup> setups, const PlanningShop& shop,
                           const HoleWishes& wishes);

}  // namespace stepmill
