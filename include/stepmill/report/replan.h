#pragma once

#include <string>

#include "stepmill/replan/plan_change.h"

namespace stepmill {

/// For the terminal: what was another, what became of features and operations, minutes and money.
std::string replanText(const PlanChange& change);

/// replan.json [schemas/replan.schema.json].
std::string replanJson(const PlanChange& change);

/// The same as a page: both plans beside each other, with pictures of the features that are another.
std::string replanHtml(const PlanChange& change);

}  // namespace stepmill
