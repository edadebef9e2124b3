#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// plan.json as docs/plan-json.md describes it; checked against schemas/plan.schema.json before it leaves.
/// \throws Error(Internal) if the plan breaks its own schema.
std::string planJson(const Plan& plan);

/// Where plan.json says other things of its machine than hold for this one.
struct MachineDifference {
    std::string pointer;   ///< below the machine, "/side_clearance_mm"
    std::string recorded;  ///< as JSON; empty where it is missing
    std::string expected;  ///< the same
};
std::vector<MachineDifference> machineDifferences(std::string_view plan_json, const Machine& machine);

}  // namespace stepmill
