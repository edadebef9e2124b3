#pragma once

#include <vector>

#include "plan/features/planning_shop.h"
#include "plan/planned_stage.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// Are leaning walls finished where setups see any?
bool finishesForms(const PlanningShop& shop);

/// The setups with form operations after all others, where the library has cutters for them. A wall that
/// leans to two setups is finished in the first.
std::vector<PlannedSetup> withForms(std::vector<PlannedSetup> setups, const std::vector<PlannedStage>& stages,
                                    const PlanningShop& shop, const Progress& progress,
                                    std::vector<Warning>& warnings);

/// The setups with their sharp edges broken after all else, where that is asked for. An edge that two setups
/// see is broken in the first.
std::vector<PlannedSetup> withBrokenEdges(std::vector<PlannedSetup> setups,
                                          const std::vector<PlannedStage>& stages, const PlanningShop& shop,
                                          const Progress& progress, std::vector<Warning>& warnings);

}  // namespace stepmill
