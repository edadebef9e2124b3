#pragma once

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill::access {

/// The components that are somewhere wider than `tol.sliver_mm`, untouched. Unlike an opening this leaves
/// the thin ends of a cusp in place: they carry centres that clear a strip as long as the wall beside them.
Region withoutSliverComponents(const Region& region, const Tolerances& tol);

}  // namespace stepmill::access
