#pragma once

#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill::toolpath {

/// Material thinner than this many slivers is a skin and counts as none: strips of centres as narrow as one
/// sliver get no pass, and that may be so on both sides.
inline constexpr double kSkinSlivers = 2;

/// All a disc of that radius touches on its way along lines and arcs. Exact but for rounding to the grid.
Region sweptRegion(const std::vector<Path>& ways, double radius_mm, const Tolerances& tol);

/// What such a disc leaves of a region.
Region notSwept(const Region& region, const std::vector<Path>& ways, double radius_mm, const Tolerances& tol);

/// The components that are more than skins, or next to no area.
std::vector<Region> piecesBeyondSkins(const Region& region, const Tolerances& tol);

/// These components as one region.
Region beyondSkins(const Region& region, const Tolerances& tol);

}  // namespace stepmill::toolpath
