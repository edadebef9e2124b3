#pragma once

#include <cstddef>
#include <limits>

#include "stepmill/core/deadline.h"

namespace stepmill {

/// How long planning may take before it makes do with less; by default as long as it takes.
///
/// Where all tools take too long, a few are weighed; where these do too, the feature stays as a residual
/// ("time limit"). So a part that is too much for the time it is given gets a plan, and the plan says what
/// time cost it (ADR 0010).
struct Patience {
    Deadline all_tools;                                          ///< of weighing all tools of the library
    Deadline few_tools;                                          ///< of weighing a few, and of form cutters
    Deadline end;                                                ///< of the run
    double feature_s = std::numeric_limits<double>::infinity();  ///< of one feature, in either way
    double setup_share = 1;  ///< of the time that is left, for tools of a setup that others follow

    /// Of the next setup, which so many follow.
    Patience ofOneSetup(std::size_t followers) const;

    Deadline allToolsOfOne() const { return all_tools.orEarlier(Deadline::in(feature_s)); }
    Deadline fewToolsOfOne() const { return few_tools.orEarlier(Deadline::in(feature_s)); }
};

/// For a run that ends for good in so many seconds, infinite: never. Leaves time to make the paths, prove
/// them and write all.
Patience patienceFor(double seconds);

/// For planning anew in the time that is left. All tools are weighed only where there was time for that
/// before.
Patience patienceAfter(const Patience& before);

}  // namespace stepmill
