#pragma once

#include <vector>

#include "feature/removal_forest.h"
#include "stepmill/feature/feature.h"

namespace stepmill::feature {

/// What of stock - part the removal components do not hold, from above to below; neighbouring layers with
/// the same reason and region are one entry. With the components it makes up stock - part.
std::vector<Unplanned> findUnplanned(const LayerStack& layers, const RemovalForest& forest,
                                     const Tolerances& tol);

}  // namespace stepmill::feature
