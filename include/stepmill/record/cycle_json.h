#pragma once

#include <nlohmann/json.hpp>

#include "stepmill/plan/cycle_time.h"

// Cycle times as plan.json and replan.json have them.

namespace stepmill {

nlohmann::ordered_json cycleTargetJson(const CycleTarget& target);
nlohmann::ordered_json cycleTimesJson(const CycleTimes& times);

/// The reverse.
/// \pre the JSON keeps its schema
CycleTimes cycleTimesFrom(const nlohmann::ordered_json& json);

}  // namespace stepmill
