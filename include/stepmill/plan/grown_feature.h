#pragma once

#include "stepmill/feature/feature.h"
#include "stepmill/plan/reduced_feature.h"
#include "stepmill/sequence/sequence.h"
#include "stepmill/setup/stock_growth.h"

namespace stepmill {

/// The feature as its tools find it on the grown stock: the target goes on over its open edges as far as the
/// stock may, a raw top stands higher, obstacles stand out farther, and the skirt is what may stand beside
/// the obstruction. Without growth the feature as it is; one with an empty target too.
/// \param feature  beside all that stands by the plan: reduced() (plan/reduced_feature.h)
Feature onGrownStock(Feature feature, const StockGrowth& growth, const Tolerances& tol);

/// What is to be cut of a feature on the grown stock.
struct GrownTarget {
    Region region;
    double top_z_mm = 0;
};
/// Target and top of onGrownStock() alone, which costs a fraction: no obstacle is looked at.
GrownTarget targetOnGrownStock(const Feature& feature, const StockGrowth& growth, const Tolerances& tol);

/// A feature as its tools find it: below what those above it left, beside the fixtures, on the grown stock.
Feature asFound(const Feature& feature, const CutById& by_id, const std::vector<Fixture>& fixtures,
                const StockGrowth& growth, const Tolerances& tol);

/// Target and top of asFound() alone.
GrownTarget targetAsFound(Feature feature, const CutById& by_id, const std::vector<Fixture>& fixtures,
                          const StockGrowth& growth, const Tolerances& tol);

/// Obstacles as they may stand: raw sides farther out, a raw top higher.
std::vector<Obstacle> onGrownStock(std::vector<Obstacle> obstacles, const StockGrowth& growth,
                                   const Tolerances& tol);

/// What tools leave of the grown feature, as residuals of the feature itself.
std::vector<Residual> onNominalStock(std::vector<Residual> residual, const Feature& feature,
                                     const Feature& grown, const Tolerances& tol);

}  // namespace stepmill
