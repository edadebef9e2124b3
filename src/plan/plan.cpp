#include "stepmill/plan/plan.h"

#include <algorithm>

namespace stepmill {

bool Plan::complete(const Tolerances& tol) const {
    for (const PlannedSetup& setup : setups) {
        for (const PlannedFeature& planned : setup.features) {
            if (!planned.sequence.residual.empty()) return false;
        }
    }
    const double rounding_mm3 = std::max(kVolumeRoundingMm3, tol.volume_share * balance.stock_minus_part_mm3);
    return balance.unreachable_mm3 <= rounding_mm3 && balance.gapShare() <= tol.volume_share;
}

}  // namespace stepmill
