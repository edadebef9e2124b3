#pragma once

#include "stepmill/verify/plan_record.h"

namespace stepmill::report {

/// plan.json and the programs as they would be written.
PlanFiles postedFiles(const Plan& plan);

}  // namespace stepmill::report
