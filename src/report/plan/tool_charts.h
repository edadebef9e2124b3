#pragma once

#include <optional>

#include "report/page/element.h"
#include "report/page/measures.h"
#include "stepmill/plan/plan.h"

namespace stepmill::report {

/// What the cutters of the library reach of a setup's features, and what a second one in front would save:
/// the TAD curve, the DVCD curve and the RDVC chart of [Lim2000, Fig. 5 to 7], with the ranking they lead to.
/// Made of what the plan has looked at. Nothing where no cutter reaches anything.
std::optional<Element> toolCharts(const Plan& plan, const PlannedSetup& setup, const Measures& in);

/// From which tool change time on another sequence is cheaper [Yao2000, Fig. 8], over the edges that were
/// weighed. Nothing where there is no choice.
std::optional<Element> changeTimeChart(const Plan& plan, const ToolSequence& sequence);

}  // namespace stepmill::report
