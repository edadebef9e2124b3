#include "stepmill/plan/plan.h"

#include <algorithm>

namespace stepmill {
namespace {

/// What of it stays against the plan's will.
double unwantedMm3(const std::vector<ReasonVolume>& left, bool roughing) {
    double sum_mm3 = 0;
    for (const ReasonVolume& entry : left)
        if (!roughing || !isLeftByRoughing(entry.reason)) sum_mm3 += entry.volume_mm3;
    return sum_mm3;
}

}  // namespace

bool Plan::complete(const Tolerances& tol) const {
    const bool roughing = request.roughing.has_value();
    // A residual of one setup may be gone in a later one: what counts is what is left at the end.
    if (unwantedMm3(balance.residual_by_reason, roughing) > kVolumeRoundingMm3) return false;
    const double rounding_mm3 = std::max(kVolumeRoundingMm3, tol.volume_share * balance.stock_minus_part_mm3);
    return unwantedMm3(balance.unreachable_by_reason, roughing) <= rounding_mm3 &&
           balance.gapShare() <= tol.volume_share;
}

}  // namespace stepmill
