#pragma once

#include <optional>
#include <vector>

#include "planar/clearance/profile.h"

namespace stepmill::clearance {

/// A point of the boundary whose clearance equals the level's.
struct Place {
    int site = 0;
    double u = 0;
    int stop = kUnbounded;
    Vec2 centre = Vec2::Zero();  ///< of its disc: a vertex of the ring

    bool before(const Place& other) const { return site != other.site ? site < other.site : u < other.u; }
};

/// A stretch of boundary with more clearance than the level, as long as it can be, in the direction of
/// travel.
struct Run {
    int loop = 0;
    bool whole = false;  ///< the whole loop; `begin` and `end` say nothing
    Place begin;
    Place end;
    /// The disc at this run's end touches the boundary again where another run begins: that run. Itself if
    /// whole.
    int next = kNone;
};

/// The boundary cut where the clearance passes one distance.
struct Level {
    double distance = 0;
    /// The clearance at which the boundary is cut. It lies up to 2 nm beside `distance`, so that no vertex of
    /// the diagram and no tie has this very clearance.
    double cut = 0;
    std::vector<Run> runs;  ///< in the order of the sites, then along them
};

/// How a level treats discs that just fit.
enum class Tie {
    Blocked,  ///< nothing passes: a neck is closed, an arc of that radius is gone
    Filled    ///< a concave arc of that radius stays; necks are closed even so
};

/// Nothing where ends and beginnings of runs do not pair up because rounding has moved vertices.
std::optional<Level> levelAt(const Profile& profile, double distance_mm, Tie tie);

}  // namespace stepmill::clearance
