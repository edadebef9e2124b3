#pragma once

#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill::toolpath {

/// All a disc of that radius touches on its way along lines and arcs. Exact but for rounding to the grid.
Region sweptRegion(const std::vector<Path>& ways, double radius_mm, const Tolerances& tol);

/// What such a disc leaves of a region.
Region notSwept(const Region& region, const std::vector<Path>& ways, double radius_mm, const Tolerances& tol);

/// The components that are more than skins: thinner than two slivers, since strips of centres as narrow as
/// one get no pass and that may be so on both sides, or next to no area.
std::vector<Region> piecesBeyondSkins(const Region& region, const Tolerances& tol);

/// These components as one region.
Region beyondSkins(const Region& region, const Tolerances& tol);

}  // namespace stepmill::toolpath
