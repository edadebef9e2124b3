#pragma once

#include "stepmill/setup/in_process.h"

namespace stepmill::setup {

/// The same solid as fewer walls: where a prism stands under another that covers it, it grows to the top of
/// that one, which keeps only what lies beside it. A pocket in a pocket then is a shaft and a ring instead of
/// two boxes, and walls that run through are one face. Interiors still do not meet.
std::vector<Prism> uprightStacks(std::vector<Prism> prisms, const Tolerances& tol);

}  // namespace stepmill::setup
