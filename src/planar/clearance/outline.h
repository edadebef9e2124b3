#pragma once

#include "planar/clearance/level.h"

namespace stepmill::clearance {

/// Points with more clearance than the level: the ring loops and what they enclose.
Region ringsOf(const Profile& profile, const Level& level);

/// The level without rings around nothing: rooms in which the disc just fits.
Level withoutEmptyRings(const Profile& profile, const Level& level);

/// The region without what is narrower than the level's discs: cut off straight, from wall to wall, where it
/// begins. Corners stay as they are. Nothing where its walls see different discs.
std::optional<Region> withoutStrips(const Profile& profile, const Level& level);

/// The ground that discs of the level's radius sweep when they roll along the boundary: its loops are the
/// runs and, between them, arcs of the discs.
struct Swept {
    Region region;
    /// Discs on both sides of a narrow place overlap; the region then winds around some points twice.
    bool overlapping = false;
};
/// Nothing where rounding makes the two walls of one disc see its centre at different places: no arc fits
/// both.
std::optional<Swept> sweptBy(const Profile& profile, const Level& level);

/// Centres at `fine.distance` from the boundary whose discs reach beyond the ground that the discs of
/// `coarse` sweep; nothing where the two levels do not nest run by run.
/// \pre discs of `coarse` do not overlap at necks
std::optional<Region> centresLeft(const Profile& profile, const Level& coarse, const Level& fine);

}  // namespace stepmill::clearance
