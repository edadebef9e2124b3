// Where other setups may cut what stays.

#include "plan/assignment/unreached_places.h"

#include <algorithm>
#include <limits>

#include "plan/residual_prisms.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill {
namespace {

/// What stays is worth another setup from this share of all that is to be removed, ...
constexpr double kPaysShare = 1e-3;
/// ... or, of a hole, of its feature: half a small hole is worth its setup, ...
constexpr double kPaysHoleShare = 0.5;

bool mayBeReachedElsewhere(const StayReason& reason) {
    return reason == Reason::TooDeep || reason == Reason::HolderCollision || reason == Reason::NoWayIn ||
           reason == Reason::Fixture;
}

/// Points well inside the pieces of the region.
std::vector<Vec2> middlesOf(const Region& region) {
    std::vector<Vec2> middles;
    for (const Region& piece : components(region))
        if (const auto disc = ClearanceDiagram(piece, Tolerances{}).largestInscribedDisc())
            middles.push_back(disc->centre);
    return middles;
}

/// What of a residual makes a setup of its own pay.
double paysFromMm3(const ResidualPrism& left, const Plan& plan) {
    double pays_mm3 = kPaysShare * plan.balance.stock_minus_part_mm3;
    const Feature& feature = left.feature->feature;
    if (isHole(feature.feature_class)) pays_mm3 = std::min(pays_mm3, kPaysHoleShare * feature.volume_mm3);
    return std::max(kWorthAWarningMm3, pays_mm3);
}

}  // namespace

Unreached unreachedIn(const Plan& plan) {
    Unreached unreached;
    unreached.pays_mm3 = std::numeric_limits<double>::infinity();
    for (const PlannedSetup& planned : plan.setups)
        for (const ResidualPrism& left : residualPrisms(planned.features)) {
            const double stays_mm3 = left.of->stays_mm3.value_or(0);
            const double pays_mm3 = paysFromMm3(left, plan);
            if (!mayBeReachedElsewhere(left.reason) || stays_mm3 < pays_mm3) continue;
            unreached.pays_mm3 = std::min(unreached.pays_mm3, pays_mm3);
            const double z_mm = (left.prism.top_z_mm + left.prism.bottom_z_mm) / 2;
            const std::vector<Vec2> middles = middlesOf(left.prism.region);
            for (const Vec2& middle : middles) {
                const Vec3 at = planned.setup.part_to_setup.inverse() * Vec3(middle.x(), middle.y(), z_mm);
                unreached.places.push_back(
                    {at, planned.setup.axis, stays_mm3 / static_cast<double>(middles.size())});
            }
        }
    return unreached;
}

}  // namespace stepmill
