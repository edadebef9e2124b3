#pragma once

#include <vector>

#include "stepmill/replan/plan_change.h"

namespace stepmill::replan {

/// What the second plan was made with that the first was not, but for the part.
std::vector<InputChange> inputChanges(const RecordedPlan& before, const RecordedPlan& after);

}  // namespace stepmill::replan
