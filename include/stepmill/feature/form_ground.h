#pragma once

#include <string>
#include <vector>

#include "stepmill/feature/feature.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// What flat layers leave over the leaning walls of a setup, and what form cutters must keep clear of while
/// they take it off. In setup coordinates [mm].
///
/// The heights of the bands are those of the slabs the part was cut into on demand. A section covers what it
/// stands for at every height of its band, so a tool that keeps clear of it keeps clear of the part.
struct FormGround {
    std::string id;  ///< "S1.W"
    std::string setup_id;
    /// The sections know of nothing beyond it: the tool stays inside with all of itself.
    Region window;
    /// What must stay: part, fixtures, and stock that other operations do not clear. Bands from below to
    /// above, without gaps, up to the highest of these.
    std::vector<Obstacle> must_stand;
    /// What the flat layers left and no later setup takes: the stairs. Bands from below to above.
    std::vector<Obstacle> stairs;
    /// All that stands when the form operations begin, as Feature::obstacles: anywhere at or above the
    /// bottom.
    std::vector<Obstacle> obstacles;
};

/// The id of a setup's ground.
inline std::string formGroundId(const std::string& setup_id) {
    return setup_id + ".W";
}

}  // namespace stepmill
