#pragma once

#include <vector>

#include "stepmill/study/quote.h"

namespace stepmill {

/// The features of a plan that cost most, three at most, each with what would make it cheaper: larger inner
/// corners, less depth. Each change is sequenced on real paths, beside the feature as it is; what saves
/// nothing, or leaves material for another reason than its corners, is left out. Fewer where the time that
/// the plan was given (Patience::end) comes to its end.
/// \param progress  told of each feature
std::vector<CostlyFeature> costlyFeatures(const Plan& plan, const Tolerances& tol, const Progress& progress);

}  // namespace stepmill
