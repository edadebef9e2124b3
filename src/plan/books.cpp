#include <fmt/format.h>

#include "plan/plan_steps.h"

namespace stepmill {
namespace {

bool spans(double top_z_mm, double bottom_z_mm, double z_mm) {
    return bottom_z_mm < z_mm && z_mm < top_z_mm;
}

/// Removal of a slab that its features and its unplanned volumes do not account for [mm3].
double slabGap(const Layer& layer, const PlannedSetup& setup) {
    const double middle = (layer.top_z_mm + layer.bottom_z_mm) / 2;
    double gap = (area(layer.stock) - area(layer.part)) * layer.height_mm() + layer.sloped_volume_mm3;
    for (const PlannedFeature& planned : setup.features) {
        const Feature& feature = planned.feature;
        if (spans(feature.top_z_mm, feature.floor_z_mm, middle)) gap -= feature.area_mm2 * layer.height_mm();
    }
    for (const Unplanned& unplanned : setup.unplanned) {
        if (!spans(unplanned.top_z_mm, unplanned.bottom_z_mm, middle)) continue;
        const double height = unplanned.top_z_mm - unplanned.bottom_z_mm;
        gap -= unplanned.volume_mm3 * layer.height_mm() / height;
    }
    return gap;
}

}  // namespace

double VolumeBalance::gapShare() const {
    if (stock_minus_part_mm3 <= kVolumeRoundingMm3) return 0;
    const double gap = stock_minus_part_mm3 - planned_mm3 - residual_mm3 - unreachable_mm3;
    return std::abs(gap) / stock_minus_part_mm3;
}

void balanceBooks(Plan& plan, double stock_minus_part_mm3) {
    VolumeBalance balance;
    balance.stock_minus_part_mm3 = stock_minus_part_mm3;
    for (const PlannedSetup& setup : plan.setups) {
        for (const PlannedFeature& planned : setup.features) {
            double residual = 0;
            for (const Residual& left : planned.sequence.residual)
                residual += left.volume_mm3;
            balance.residual_mm3 += residual;
            balance.planned_mm3 += planned.feature.volume_mm3 - residual;
        }
        for (const Unplanned& unplanned : setup.unplanned)
            balance.unreachable_mm3 += unplanned.volume_mm3;
    }
    plan.balance = balance;
}

std::string largestGap(const LayerStack& layers, const PlannedSetup& setup, const Tolerances& tol) {
    const Layer* worst = nullptr;
    double worst_mm3 = tol.volume_share * (layers.stock_volume_mm3 - layers.part_volume_mm3) / 10;
    for (const Layer& layer : layers.layers) {
        const double gap = slabGap(layer, setup);
        if (std::abs(gap) <= std::abs(worst_mm3)) continue;
        worst = &layer;
        worst_mm3 = gap;
    }
    if (worst == nullptr) return {};
    return fmt::format("largest difference {:.4g} mm3 between z {:.4g} and {:.4g} mm of {}", worst_mm3,
                       worst->top_z_mm, worst->bottom_z_mm, setup.setup.id);
}

}  // namespace stepmill
