#pragma once

#include <string>

#include "report/page/faceted_part.h"
#include "stepmill/proven/proven_plan.h"

namespace stepmill::report {

/// All that the viewer shows, as JSON with packed bytes in base64 [docs/report.md, 'The viewer's data']: the
/// part's facets; of every setup the stock as it arrives, fixtures, features and the moves of its operations.
/// What stands after an operation is cut from these in the page. Paths are thinned where they would be too
/// long for a page. The same for any number of threads.
/// \param part  the plan's
/// \throws Error(GeometryKernel)
std::string viewerData(const ProvenPlan& proven, const FacetedPart& part, bool inch);

}  // namespace stepmill::report
