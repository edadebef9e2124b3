#pragma once

#include <functional>
#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// Sets of setups for one part.
struct SetupSets {
    std::vector<Setup> chosen;      ///< by what they reach and finish
    std::vector<Setup> with_forms;  ///< others, no more of them, for form cutters; empty: none are
    double forms_leave_mm3 = 0;     ///< what those may leave, as ridges and skins of bands
    OtherSetups others;             ///< that see about as much
    bool more_may_follow = false;   ///< setups for what tools did not get to
};

/// Makes the plan of a set of setups.
/// \param flat_by  planning in flat layers is given up then
/// \throws Error(TimedOut) where it is
using PlanOfSetups = std::function<Plan(const std::vector<Setup>&, const Deadline& flat_by)>;

/// The best of whole plans. Setups that are quicker to set up come first: where no plan of those chosen could
/// be better, none is made. Beside small plans the order that leaves the least steps is planned, all others
/// where the lot keeps the machine busy for a shift, or where a small plan is far from its lower bound; none
/// whose setting up takes longer than there is to win. At last setups are added from sides that are free to
/// what the tools did not get to. What was weighed stands in the plan's choices.
/// \see docs/algorithms/setups.md, sections 8 to 10
Plan bestPlan(const SetupSets& sets, const PlanRequest& request, const Machine& machine,
              const PlanOfSetups& plan_of);

}  // namespace stepmill
