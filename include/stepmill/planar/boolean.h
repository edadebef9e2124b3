#pragma once

#include <span>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// Booleans between regions of lines and arcs.
///
/// Carried out by GEOS OverlayNG on tessellations in which equal circles have equal vertices; afterwards
/// every piece gets back the line or arc it came from, and joints are recomputed from these. Boundaries
/// that coincide within `tol.linear_mm` are treated as one. Pieces thinner than that vanish.
/// O((n + k) log n) for n tessellated edges and k crossings.
/// \throws Error(GeometryKernel) when GEOS fails on valid input.
Region unite(const Region& a, const Region& b, const Tolerances& tol);
Region unite(std::span<const Region> regions, const Tolerances& tol);
Region intersect(const Region& a, const Region& b, const Tolerances& tol);
/// Points of `a` not in the interior of `b`.
Region subtract(const Region& a, const Region& b, const Tolerances& tol);

/// A path cut at a region's boundary. Pieces keep the path's direction and order.
struct SplitPath {
    std::vector<Path> inside;   ///< pieces in the region's interior
    std::vector<Path> on;       ///< pieces along its boundary, within `tol.linear_mm`
    std::vector<Path> outside;  ///< pieces outside
};
SplitPath split(const Path& path, const Region& region, const Tolerances& tol);

/// Does every point of `inner` lie in `outer`, but for strips thinner than `slack_mm` at the boundary?
bool covers(const Region& outer, const Region& inner, double slack_mm, const Tolerances& tol);

/// The region without parts narrower than `width_mm`: what a disc of that diameter can sweep inside it,
/// to within the disc's rounding of corners.
Region withoutSlivers(const Region& region, double width_mm, const Tolerances& tol);

}  // namespace stepmill
