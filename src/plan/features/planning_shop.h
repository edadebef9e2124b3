#pragma once

#include <map>
#include <string>

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

}  // namespace stepmill
