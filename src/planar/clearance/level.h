#pragma once

#include <optional>
#include <vector>

#include "planar/clearance/profile.h"

namespace stepmill::clearance {

/// A point of the boundary whose clearance is just the level's.
struct Place {
    int site = 0;
    double u = 0;
    int stop = kUnbounded;
    Vec2 centre = Vec2::Zero();  ///< of its disc: a vertex of the ring

    bool before(const Place& other) const { return site != other.site ? site < other.site : u < other.u; }
};

/// A longest stretch of boundary with more clearance than the level, in the direction of travel.
struct Run {
    int loop = 0;
    bool whole = false;  ///< the whole loop; `begin` and `end` say nothing
    Place begin;
    Place end;
    /// The run that begins where the disc at this one's end touches again. Its own index if whole.
    int next = kNone;
};

/// The boundary cut where the clearance passes one distance.
struct Level {
    double distance = 0;
    /// The clearance really cut at: up to 2 nm beside `distance`, so that no vertex of the diagram and no tie
    /// has just that.
    double cut = 0;
    std::vector<Run> runs;  ///< in the order of the sites, then along them
};

/// What a level does with discs that just fit.
enum class Tie {
    Blocked,  ///< nothing passes: a neck is closed, an arc of that radius is gone
    Filled    ///< a concave arc of that radius stays; necks are closed even so
};

/// Nothing where ends and beginnings of runs do not pair up: rounding has moved vertices there.
std::optional<Level> levelAt(const Profile& profile, double distance_mm, Tie tie);

}  // namespace stepmill::clearance
