#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "plan/features/planning_shop.h"
#include "stepmill/plan/assignment.h"

namespace stepmill {

/// What of a planned setup's work later setups would do for less, by estimate; nothing where they would not,
/// or save less than kLeastGainS.
///
/// The later setups are walked on the stock that the setup arrives with, as if it cut nothing, and their
/// bands that reach its work are sequenced one by one. The cells that both reach are then left or cut so that
/// the sum of their times is least: exact for these times (best_closure.h). It is no less of plans made by
/// cost: they are judged by it once they are made.
/// \param planned  with sequences; its steps' paths may be gone
/// \param layers   of it
/// \param setups   all of the part, in order
/// \param later    places among them of the setups that cut after it
/// \throws Error(TimedOut) where the time to weigh all tools is over
std::optional<ReserveProposal> proposeReserve(const PlannedSetup& planned, const LayerStack& layers,
                                              const std::vector<Setup>& setups,
                                              const std::vector<std::size_t>& later,
                                              const PlanningShop& shop);

/// What is estimated to save less is not tried [s].
inline constexpr double kLeastGainS = 10;

}  // namespace stepmill
