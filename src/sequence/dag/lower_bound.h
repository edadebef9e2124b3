#pragma once

#include <vector>

#include "sequence/dag/candidate.h"
#include "stepmill/sequence/least_times.h"

namespace stepmill {

/// Lower bounds of a feature's machining time, see docs/algorithms/costs.md.
struct TimeBounds {
    double with_changes_s = 0;  ///< one tool change for every tool used
    LeastTimes as_cut;  ///< at the feeds that plans run with; the one above at those that the DAG weighs
};

/// \param ends  as from endTools()
TimeBounds timeBounds(const Feature& feature, const std::vector<Candidate>& tools,
                      const std::vector<bool>& ends, const Machine& machine, const Tolerances& tol);

}  // namespace stepmill
