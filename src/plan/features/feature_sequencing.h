#pragma once

#include <functional>
#include <string>

#include "plan/features/planning_shop.h"
#include "stepmill/plan/grown_feature.h"
#include "stepmill/plan/reduced_feature.h"

namespace stepmill {

/// How a feature was planned.
struct SequencedFeature {
    ToolSequence sequence;
    ReducedFeature free;  ///< what of the feature was free to be cut
    std::string failure;  ///< empty where it was planned
    bool hasty = false;   ///< few tools were weighed, or none, for want of time
};

/// The sequence of the same feature where the same of it was free; null where there is none.
using KnownSequence = std::function<const ToolSequence*(const ReducedFeature& free)>;

/// The feature's cheapest sequence in the time there is, its holes brought to their fit where a hole table
/// asks for one.
/// \param cut     the features that it waits for, as they are planned
/// \param known   asked before it is planned
/// \param growth  how much larger the stock may be
/// \return  the feature as a residual with the reason where its planning fails: one bad pocket must not lose
///          the plan
SequencedFeature sequenceFeature(const Feature& feature, const CutById& cut, const KnownSequence& known,
                                 const Setup& setup, const StockGrowth& growth, const PlanningShop& shop);

}  // namespace stepmill
