#pragma once

#include "stepmill/feature/whole_feature.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// Of a whole feature, by itself.
struct FeatureTimes {
    double time_s = 0;
    double motion_s = 0;       ///< `time_s` with the machine's acceleration where that is given
    double lower_bound_s = 0;  ///< no plan of it with these tools can be faster
};

/// What a feature's bands take together. A tool goes down all bands before the next one comes, so each is
/// changed to as often as in the band that calls it most; of a feature of one band the times are its
/// sequence's own.
FeatureTimes timesOf(const WholeFeature<PlannedFeature>& feature, const Machine& machine);

}  // namespace stepmill
