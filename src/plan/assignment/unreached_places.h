#pragma once

#include <vector>

#include "stepmill/plan/plan.h"

namespace stepmill {

/// Where tools were too short, or shank, holder or a fixture in the way.
struct Unreached {
    /// In each piece of what stays for that, but for residuals that would not pay for a setup.
    std::vector<UnreachedPlace> places;
    double pays_mm3 = 0;  ///< so much of them does at least
};

/// From another side some may get there.
Unreached unreachedIn(const Plan& plan);

}  // namespace stepmill
