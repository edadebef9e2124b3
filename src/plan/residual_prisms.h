#pragma once

#include <vector>

#include "stepmill/plan/plan.h"
#include "stepmill/setup/prism.h"

namespace stepmill {

/// A residual as it stands.
struct ResidualPrism {
    StayReason reason;
    double volume_mm3 = 0;
    Prism prism;
    const Residual* of = nullptr;  ///< null: allowance or held stock, which are no feature's
    const PlannedFeature* feature = nullptr;
};
std::vector<ResidualPrism> residualPrisms(const std::vector<PlannedFeature>& features);

/// A prism and the setup in whose coordinates it is.
struct SetupPrism {
    const Setup* setup = nullptr;
    Prism prism;
};
/// Share of the prism's volume that lies in none of the others, from points in it [0..1].
double shareOutside(const Setup& setup, const Prism& prism, const std::vector<SetupPrism>& others);

}  // namespace stepmill
