#pragma once

#include <string>

#include "stepmill/plan/plan.h"

namespace stepmill::report {

/// What makes the plan longer than its lower bound, in minutes and seconds; empty without a bound.
std::string overBoundWords(const Plan& plan);

}  // namespace stepmill::report
