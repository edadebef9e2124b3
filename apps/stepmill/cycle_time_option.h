#pragma once

#include <string>
#include <vector>

#include "stepmill/plan/cycle_time.h"

namespace stepmill {

/// What --cycle-time means: "4:30" or "1:04:30" for the part, "S1=2:00" for a setup, "S1.F3=0:45" for a
/// feature; seconds may have decimals. None for a single "off".
/// \throws Error(Usage) for other words, a time of zero or beyond kLongestCycleTimeS, and two times of one thing
std::vector<CycleTarget> cycleTargets(const std::vector<std::string>& words);

}  // namespace stepmill
