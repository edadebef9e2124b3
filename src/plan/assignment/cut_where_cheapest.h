#pragma once

#include <vector>

#include "plan/cut_setups.h"
#include "stepmill/plan/assignment.h"

namespace stepmill {

/// Every setup first cuts all it reaches; then, setup after setup, what later ones would do for less is left
/// to them, as long as all gets better by it.
/// \param assignment  what is known of it, and gets known
CutSetups cutWhereCheapest(const std::vector<Setup>& setups, double stock_minus_part_mm3,
                           const PlanningShop& shop, const Progress& progress, Assignment& assignment);

}  // namespace stepmill
