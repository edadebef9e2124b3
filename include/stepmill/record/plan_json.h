#pragma once

#include <string>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// plan.json as docs/plan-json.md describes it; checked against schemas/plan.schema.json before it leaves.
/// \throws Error(Internal) if the plan breaks its own schema.
std::string planJson(const Plan& plan);

}  // namespace stepmill
