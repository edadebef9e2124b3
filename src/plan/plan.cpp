#include "stepmill/plan/plan.h"

#include <algorithm>

namespace stepmill {

bool Plan::complete(const Tolerances& tol) const {
    // A residual of one setup may be gone in a later one: what counts is what is left at the end.
    if (balance.residual_mm3 > kVolumeRoundingMm3) return false;
    const double rounding_mm3 = std::max(kVolumeRoundingMm3, tol.volume_share * balance.stock_minus_part_mm3);
    return balance.unreachable_mm3 <= rounding_mm3 && balance.gapShare() <= tol.volume_share;
}

}  // namespace stepmill
