#pragma once

#include "stepmill/feature/whole_feature.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// Of a whole feature, by itself.
struct FeatureTimes {
    double time_s = 0;         ///< of its operations as they run, with its changes of tools
    double motion_s = 0;       ///< `time_s` with the machine's acceleration where that is given
    double lower_bound_s = 0;  ///< no plan of it with these tools can be faster
};

/// What a feature's bands take together. A tool goes down all bands before the next one comes, so each is
/// changed to as often as in the band that calls it most.
/// \param operations  of its setup, others among them
FeatureTimes timesOf(const WholeFeature<PlannedFeature>& feature, const std::vector<Operation>& operations,
                     const Machine& machine);

/// What one of them takes at least, at no higher feeds than its operations are paced to.
LeastTimes leastTimesAsFed(const PlannedFeature& band, const std::vector<Operation>& operations);

}  // namespace stepmill
