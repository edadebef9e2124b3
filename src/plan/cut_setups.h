#pragma once

#include <vector>

#include "plan/order/share_tools.h"
#include "plan/planned_stage.h"
#include "stepmill/plan/books.h"

namespace stepmill {

/// Setups with all that mills and drills cut in flat layers, at the library's feeds, and the stages they came
/// from.
struct CutSetups {
    std::vector<PlannedStage> stages;
    std::vector<PlannedSetup> setups;  ///< moved out of the stages
    ToolSharing sharing;
    int threads_missing = 0;
    PlanTotals totals;
    std::vector<Warning> warnings;  ///< of time that was short, then of threads
};

/// Plans the setups as they stand, each on what those before it leave.
CutSetups cutSetups(const std::vector<Setup>& setups, const std::vector<CutPrisms>& reserves,
                    const PlanningShop& shop, const Progress& progress);

/// \param setups  moved out of the stages, with their operations or without
PlanBooks booksOf(const std::vector<PlannedSetup>& setups, const std::vector<PlannedStage>& stages,
                  double stock_minus_part_mm3, const Tolerances& tol);

}  // namespace stepmill
