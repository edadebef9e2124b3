#pragma once

#include <span>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// Booleans between regions of lines and arcs.
///
/// Carried out on the lines and arcs themselves: all boundaries are cut where they meet, coinciding pieces
/// become one piece, winding numbers tell what lies on both sides of each, and the pieces between inside
/// and outside are joined to loops again. Every edge of the result lies on a line or circle of an operand;
/// neighbours on one carrier are merged, so arcs stay arcs. Boundaries that coincide within `tol.linear_mm`
/// are treated as one (the one of `a` stays). Loops thinner than that vanish. Input so crowded that no
/// snapping distance gives one answer is cut on chords of 0.1 um instead; the result may then differ from
/// the true one by twice that.
///
/// Loops come ordered by their lowest, then leftmost vertex and start there. The order of operands of
/// `unite` and `intersect` changes the result by no more than the tolerance.
/// O(n log n + k + (n + k) j) for n edges, k crossings and j stretches of boundary between crossings.
/// \throws Error(GeometryKernel) when the pieces do not close up on valid input.
/// \see docs/adr/0001-planar-kernel.md
Region unite(const Region& a, const Region& b, const Tolerances& tol);
Region unite(std::span<const Region> regions, const Tolerances& tol);
Region intersect(const Region& a, const Region& b, const Tolerances& tol);
/// Points of `a` not in the interior of `b`.
Region subtract(const Region& a, const Region& b, const Tolerances& tol);
/// Points of `a` in the interior of none of `many`: quicker than a difference with their union.
Region subtract(const Region& a, std::span<const Region> many, const Tolerances& tol);

/// What a closed path winds round counter-clockwise, once or more; it may cross and touch itself.
Region encircled(const Loop& loop, const Tolerances& tol);

/// A path cut at a region's boundary. Pieces keep the path's direction and order.
struct SplitPath {
    std::vector<Path> inside;   ///< pieces in the region's interior
    std::vector<Path> on;       ///< pieces along its boundary, within `tol.linear_mm`
    std::vector<Path> outside;  ///< pieces outside
};
SplitPath split(const Path& path, const Region& region, const Tolerances& tol);

/// Does every point of `inner` lie in `outer`, but for strips thinner than `slack_mm` at the boundary?
bool covers(const Region& outer, const Region& inner, double slack_mm, const Tolerances& tol);

}  // namespace stepmill
