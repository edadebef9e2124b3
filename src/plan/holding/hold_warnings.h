#pragma once

#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// What the setter must know of how setups are held: nothing is known that holds one, or tape and glue alone
/// do; cutters come into what one rests on; held stock stays on the part.
std::vector<Warning> holdWarnings(const Plan& plan);

}  // namespace stepmill
