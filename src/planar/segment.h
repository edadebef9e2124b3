#pragma once

#include "stepmill/planar/region.h"

namespace stepmill::planar {

/// A kilometre: the 1 nm grid still has all its digits in a double there. Readers refuse more.
inline constexpr double kLargestMm = 1e6;

/// Does the ray from the arc's centre through p meet the arc from `from` to `to`? True at the ends.
bool inSweep(const Vec2& from, const Vec2& to, const Arc& arc, const Vec2& p);

/// Around the true curve, its ends included.
Box2 boundingBox(const Vec2& from, const Segment& segment);

/// Is the arc's sweep larger than that? Most arcs are less than a half circle, which costs no angle to tell.
/// \pre least_rad >= pi
bool sweepsMoreThan(double least_rad, const Vec2& from, const Vec2& to, const Arc& arc);

/// Where on the segment p lies, as a share of its length; outside [0, 1] beyond its ends.
double shareOf(const Vec2& p, const Vec2& from, const Segment& segment);

/// The radius of a circle on the grid, told from one point on it. Rounding may make it another than meant.
inline double radiusThrough(const Vec2& on_circle, const Vec2& centre) {
    return snapToGrid((on_circle - centre).norm());
}

/// Number of equal chords of at most that sagitta for an arc of that sweep; at least 1.
int stepsForSweep(double sweep_rad, double radius_mm, double chord_mm);

/// A segment's share in the winding number of its loop about p. `side` is 0 where p lies away from the
/// segment; otherwise p is the segment's middle and counts as just left (+1) or just right (-1) of it.
/// \pre side == 0 or the segment is no more than a half circle
int windingShare(const Vec2& from, const Segment& segment, const Vec2& p, int side = 0);

/// How often the loop winds around p, which must not lie on it.
int windingNumber(const Loop& loop, const Vec2& p);
int windingNumber(const Region& region, const Vec2& p);

/// The lowest point of the true curve; of several the leftmost.
Vec2 lowestPoint(const Path& path);

/// Of the middles of `loop`'s edges the one farthest from `other`.
Vec2 pointAwayFrom(const Loop& loop, const Loop& other);

}  // namespace stepmill::planar
