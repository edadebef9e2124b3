#pragma once

#include <vector>

#include "plan/features/planning_shop.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// The features of a setup with their sequences.
struct PlannedFeatures {
    std::vector<PlannedFeature> features;
    std::vector<Warning> warnings;  ///< of features whose planning failed or that few tools were weighed for
};

/// Plans features generation by generation, each below what those above it leave.
/// \param progress  told of each feature, with the share of them that is begun
PlannedFeatures planFeatures(std::vector<Feature> features, const Setup& setup, const PlanningShop& shop,
                             const Progress& progress);

}  // namespace stepmill
