#pragma once

#include "report/page/element.h"
#include "stepmill/plan/plan.h"

namespace stepmill::report {

/// A setup from above its front left corner, which has the work offset, hidden lines removed.
struct SetupPictures {
    Element arriving;  ///< stock and fixtures with work offset and tool axis; shaded: what is cut here
    Element leaving;   ///< the same when all is cut; shaded: what was cut here
};

/// \param before  the setup before; null for the first
/// \throws Error(GeometryKernel)
SetupPictures setupPictures(const PlannedSetup& setup, const Setup* before, const Tolerances& tol);

}  // namespace stepmill::report
