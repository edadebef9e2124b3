#pragma once

#include <string>

#include "stepmill/plan/plan.h"
#include "stepmill/post/post.h"

// The sections of report.html that belong to one setup or to one feature.

namespace stepmill {

/// Views, the setup sheet with its features, tools and operations.
std::string setupHtml(const Plan& plan, const PlannedSetup& setup, Dialect dialect);

/// What each step sweeps, what stays, and all that was weighed.
std::string featureHtml(const PlannedSetup& setup, const PlannedFeature& planned);

/// How often the bound goes into a time: "2.31"; "-" without a bound.
std::string timesBound(double value_s, double bound_s);

}  // namespace stepmill
