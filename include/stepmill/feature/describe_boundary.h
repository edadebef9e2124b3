#pragma once

#include "stepmill/feature/feature.h"

namespace stepmill {

/// Fills in what follows from a feature's target, obstruction and `through`: the pieces of its boundary,
/// their lengths, the least corner radius and the class.
void describeBoundary(Feature& feature, const Tolerances& tol);

}  // namespace stepmill
