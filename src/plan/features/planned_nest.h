#pragma once

#include <limits>
#include <string>
#include <vector>

#include "plan/features/feature_sequencing.h"

namespace stepmill {

/// Planned features that belong together, parents before children.
struct PlannedNest {
    /// How one of them came to be planned so.
    struct Making {
        ReducedFeature free;  ///< what of it was free to be cut
        std::string failure;  ///< empty where it was planned
        bool hasty = false;   ///< few tools were weighed, or none, for want of time
    };

    std::vector<PlannedFeature> features;
    std::vector<Making> makings;  ///< of each

    void add(const Feature& feature, SequencedFeature made);
    bool failed() const;
    bool isHasty() const;
    double residualMm3() const;
    /// The sequence of the feature of that id, if it found the same room; null where there is none.
    const ToolSequence* sequenceIn(const ReducedFeature& free) const;
};

/// Seconds or money of all paths, without tool changes.
double pathsWeight(const PlannedNest& nest, const PlanningShop& shop);

/// Seconds or money of all paths and tool changes, with tools shared as the plan will share them.
double weightOf(const PlannedNest& nest, const PlanningShop& shop);

/// What a nest may leave and weigh to be better than another.
struct NestLimit {
    double residual_mm3 = std::numeric_limits<double>::infinity();
    double weight = std::numeric_limits<double>::infinity();
};

/// Do the features so far leave more, or do their paths alone weigh more?
bool isBeyond(const PlannedNest& nest, const NestLimit& limit, const PlanningShop& shop);

}  // namespace stepmill
