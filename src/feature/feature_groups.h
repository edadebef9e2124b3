#pragma once

#include <vector>

#include "feature/removal_forest.h"

namespace stepmill::feature {

/// Components that one feature clears, and the ground it has at its floor.
struct FeatureGroup {
    std::vector<int> components;  ///< ascending: from above to below
    Region target;                ///< in a box of stock the last component's region
};

/// Sorts the components that are not `left` into features, in the order of their first components; what a
/// feature has to wait for comes before it.
///
/// A component deepens the feature over it if it is the same region [features.md]. Where earlier
/// setups cut the stock it may also be wider or narrower, or hang together with several: as long as over the
/// common ground, from the top of the feature to its floor, there is nothing but what the feature clears and
/// air, and not too much of that.
std::vector<FeatureGroup> featureGroups(const RemovalForest& forest, const LayerStack& layers,
                                        const Tolerances& tol);

}  // namespace stepmill::feature
