#pragma once

#include <vector>

#include "plan/features/planning_shop.h"
#include "stepmill/plan/hole_wishes.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// Setups whose holes are brought to their fit and tapped as the hole table asks.
struct ThreadedSetups {
    std::vector<PlannedSetup> setups;
    int missing = 0;  ///< holes without the thread or the fit they were to get
    std::vector<Warning> warnings;
};

/// Puts the sizing steps behind the others of every hole, and a tapping step behind those of each that is to
/// be tapped, of the tap that takes least time. A thread takes nothing of the part's volume, so the books
/// stay.
/// \pre the steps still have their paths
ThreadedSetups withThreads(std::vector<PlannedSetup> setups, const PlanningShop& shop,
                           const HoleWishes& wishes);

}  // namespace stepmill
