#pragma once

#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// A place in each residual that stays since tools were too short for it, or shank, holder or a fixture in
/// the way: from another side some may get there. Not those that would not pay for a setup.
std::vector<UnreachedPlace> unreachedPlaces(const Plan& plan);

}  // namespace stepmill
