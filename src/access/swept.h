#pragma once

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill::access {

/// What a disc sweeps while its centre goes everywhere in `centres`: offset(centres, radius). Each component
/// is grown by itself and the results united, so that discs of different components that meet across a neck
/// are a matter of the Boolean alone.
Region swept(const Region& centres, double radius_mm, const Tolerances& tol);

}  // namespace stepmill::access
