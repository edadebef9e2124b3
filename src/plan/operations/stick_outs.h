#pragma once

#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// The library with every tool of a range set out as short as all its steps in the setups allow.
ToolLibrary withStickOuts(ToolLibrary library, const std::vector<PlannedSetup>& setups);

}  // namespace stepmill
