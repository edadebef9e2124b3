#pragma once

#include <vector>

#include "plan/order/order_operations.h"

namespace stepmill {

/// The features' sequences chosen for the plan: one of choicesOf() each.
struct SharedChoice {
    std::vector<std::size_t> choice;  ///< of each feature; 0 where it has none
    ToolSharing gain;                 ///< but for the features changed
};

/// Chooses one sequence a feature so that paths and tool changes of the whole plan, operations merged, weigh
/// least, and no more tools are called than the magazine has places where choices allow that: where they do
/// not, tools are changed by hand, and fewer of them are worth no longer paths. Exact where the choices have
/// few combinations (kMostCombinations); else from each feature's own cheapest by giving up tools or single
/// visits of theirs and changing single features as long as that helps. Never worse than the features' own
/// cheapest.
/// \param choices        of each feature, its own cheapest first
/// \param change_weight  of one tool change, in the unit of the choices' paths
/// \param library        tells the tools' diameters: a wide one may go down through all features first
/// \param magazine       places for tools; 0: no limit
SharedChoice shareTools(const std::vector<Precedence>& features,
                        const std::vector<std::vector<SequenceChoice>>& choices, double change_weight,
                        const ToolLibrary& library, int magazine);

/// Setups with their features' sequences as they are best together.
struct SharedSetups {
    std::vector<PlannedSetup> setups;
    ToolSharing sharing;
};

/// Makes the features' sequences anew where shareTools() finds better ones for the plan together. All choices
/// leave the same material, so what later setups found stands.
SharedSetups withSharedTools(std::vector<PlannedSetup> setups, const ToolLibrary& library,
                             const Machine& machine, Objective objective);

}  // namespace stepmill
