#pragma once

#include "planar/clearance/level.h"

namespace stepmill::clearance {

/// Points with more clearance than the level: the ring loops and what they enclose.
Region ringsOf(const Profile& profile, const Level& level);

/// The level without rings around nothing: rooms in which the disc just fits.
Level withoutEmptyRings(const Profile& profile, const Level& level);

/// What discs of the level's radius sweep whose centres have that clearance: the runs themselves and the
/// discs' arcs between them.
struct Swept {
    Region region;
    /// Discs on both sides of a narrow place overlap; the region then winds around some points twice.
    bool overlapping = false;
};
/// Nothing where rounding has set the centre of one disc apart as its two walls see it: no arc joins them.
std::optional<Swept> sweptBy(const Profile& profile, const Level& level);

/// Centres at `fine.distance` from the boundary whose discs do not lie in what the discs of `coarse` sweep;
/// nothing where the two levels do not nest run by run. \pre discs of `coarse` do not overlap across necks
std::optional<Region> centresLeft(const Profile& profile, const Level& coarse, const Level& fine);

}  // namespace stepmill::clearance
