#pragma once

#include <vector>

#include "stepmill/plan/grown_feature.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// An operation with what tells whether others may run before it.
struct EarlyOperation {
    const Operation* operation = nullptr;
    ToolAssembly tool;  ///< set out as far as the operation needs
    Region cleared;     ///< of its feature's target, down to its floor
};

/// The operations of one feature or band, in their order.
struct FeatureOperations {
    const PlannedFeature* planned = nullptr;
    std::vector<EarlyOperation> operations;
    bool plain_ways = false;  ///< FeatureCaution::plain_ways
    GrownTarget target{};     ///< of the feature, on the grown stock
};

/// What each operation of a feature waits for; an empty entry waits for all features above it.
using EarlyStarts = std::vector<std::vector<Wait>>;

/// How far the features above must be cut before each operation of a lower one may run: a wide cutter goes
/// down through all of them before a narrow one comes for their corners.
///
/// An operation waits for those of a feature above until what then still stands there is out of the way of
/// its cutter, shank and holder on every move, with a tool that is set out no farther than it needs.
///
/// \param features  of one setup, parents before children; parents that are not among them are done before
/// \return  of every feature; entries are empty where the operation waits for all, as those of features that
///          take plain ways do. Features that take them are waited for wholly.
/// \note  O(operations x features above x moves x log edges); most pairs are told apart by their boxes
std::vector<EarlyStarts> earlyStarts(const std::vector<FeatureOperations>& features, const Tolerances& tol);

}  // namespace stepmill
