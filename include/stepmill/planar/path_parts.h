#pragma once

#include "stepmill/planar/region.h"

namespace stepmill {

/// The point of a path nearest to a given one.
struct NearestPoint {
    double distance_mm = 0;
    std::size_t edge = 0;
    double share = 0;           ///< of that edge's length
    Vec2 point = Vec2::Zero();  ///< on the 1 nm grid
};
/// The first one of several. O(edges). A path without edges is its start.
NearestPoint nearestOn(const Path& path, const Vec2& p);

/// Is a closed path nothing but arcs of one circle, counter-clockwise? So is the outline of a disc, and none
/// of a hole in a region.
bool isFullCircle(const Path& closed);

/// A closed path run through from another of its points, given by edge and share of that edge's length.
/// \pre closed.closed()
Path startingAt(const Path& closed, std::size_t edge, double share);

/// Puts the edges of a path that begins where the other ends behind that one's.
void append(Path& path, const Path& more);

/// The path up to a length from its start, in (0, length]; its end is on the 1 nm grid.
Path firstPart(const Path& path, double length_mm);

}  // namespace stepmill
