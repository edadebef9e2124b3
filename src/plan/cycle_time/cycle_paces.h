#pragma once

#include <vector>

#include "plan/operations/cutting_feeds.h"
#include "plan/totals.h"
#include "stepmill/plan/cycle_time.h"

namespace stepmill {

/// Setups with their feeds and times, and what became of the times that were asked for.
struct PacedSetups {
    TimedSetups timed;
    std::vector<CycleOutcome> outcomes;  ///< in the order of the request's cycle times
};

/// withCuttingFeeds() and withTimes() at the paces that keep the request's cycle times: of features first,
/// then of setups with what is left to them, then of the part. A time that no pace keeps gets the fastest or
/// the slowest. Paces are found to a ten-thousandth, so that a time is missed by no more than 0.2 % and not
/// exceeded; each takes a few rounds of withCuttingFeeds() of what it is for.
/// \throws Error(Usage) for a cycle time of what the plan has not got
PacedSetups withCycleTimes(std::vector<PlannedSetup> setups, const CuttingFeedSettings& settings);

}  // namespace stepmill
