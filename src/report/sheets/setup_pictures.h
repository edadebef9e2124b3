#pragma once

#include "report/page/element.h"
#include "stepmill/plan/plan.h"

namespace stepmill::report {

/// A setup from above its front left corner, which has the work offset, hidden lines removed.
struct SetupPictures {
    Element arriving;  ///< stock, fixtures and what it rests on with work offset and tool axis; shaded: what
                       ///< is cut here
    Element leaving;   ///< the same when all is cut; shaded: what was cut here
};

/// \param before    the setup before; null for the first
/// \param plate_mm  thickness of the plate the setup may lie on
/// \throws Error(GeometryKernel)
SetupPictures setupPictures(const PlannedSetup& setup, const Setup* before, double plate_mm,
                            const Tolerances& tol);

}  // namespace stepmill::report
