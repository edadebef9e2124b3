#pragma once

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill::feature {

/// Equal loop by loop and edge by edge, as two results of the same operation on the same input are.
bool identical(const Region& a, const Region& b);

/// Is the region nowhere as wide as `tol.sliver_mm`? True for the empty region.
bool isSliver(const Region& region, const Tolerances& tol);

/// The same point set but for strips narrower than `tol.sliver_mm`.
bool sameRegion(const Region& a, const Region& b, const Tolerances& tol);

/// Least area difference that slivers along the region's boundary cannot explain [mm2].
double areaSlack(const Region& region, const Tolerances& tol);

}  // namespace stepmill::feature
