#pragma once

#include <map>
#include <string>
#include <vector>

#include "stepmill/plan/hold_stage.h"
#include "stepmill/plan/hole_wishes.h"
#include "stepmill/plan/plan.h"
#include "stepmill/plan/sequence_memory.h"

namespace stepmill {

/// The libraries of the features that do without some tools, by feature id.
using SmallerLibraries = std::map<std::string, ToolLibrary>;
SmallerLibraries smallerLibraries(const PlanRequest& request, const ToolLibrary& library);

/// What all features of a plan are planned with.
struct PlanningShop {
    const PlanRequest& request;
    const ToolLibrary& library;
    const SmallerLibraries& smaller;
    const HoleWishes& wishes;
    const ToolLibrary& drills;  ///< of the library, for holes that nothing else may make
    const Machine& machine;
    const Tolerances& tol;
    HoldRequest hold;
    SequenceMemory& memory;

    /// The same shop asked for something else.
    PlanningShop with(const PlanRequest& other) const {
        return {other, library, smaller, wishes, drills, machine, tol, hold, memory};
    }
    const ToolLibrary& libraryOf(const std::string& feature) const;
    /// Of the feature; one that asks for nothing where there is none.
    const FeatureCaution& cautionOf(const std::string& feature) const;
};

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
