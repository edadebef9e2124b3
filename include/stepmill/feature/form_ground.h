#pragma once

#include <string>
#include <vector>

#include "stepmill/feature/feature.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// A stretch of an edge of the part that stays sharp.
struct SharpStretch {
    Vec3 at = Vec3::Zero();  ///< on the edge, in setup coordinates
    double length_mm = 0;
    std::string why;
};

/// What flat layers leave over the leaning walls of a setup, and what form cutters must keep clear of while
/// they take it off. In setup coordinates [mm].
///
/// The heights of the bands are those of the slabs the part was cut into on demand. A section covers what it
/// stands for at every height of its band, so a tool that keeps clear of it keeps clear of the part.
///
/// A ground of edges is the same for edges that are to be broken: its stairs are what goes of the part, and
/// less of the part must stand.
struct FormGround {
    std::string id;  ///< "S1.W"; of edges "S1.E"
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
    /// How much of each edge is to go, sideways and down; 0: a ground of leaning walls.
    double edges_mm = 0;
    /// Of edges: those that stay as they are.
    std::vector<SharpStretch> sharp;

    bool isOfEdges() const { return edges_mm > 0; }
};

/// The id of a setup's ground.
inline std::string formGroundId(const std::string& setup_id) {
    return setup_id + ".W";
}
inline std::string edgeGroundId(const std::string& setup_id) {
    return setup_id + ".E";
}
inline bool isFormGround(const std::string& id, const std::string& setup_id) {
    return id == formGroundId(setup_id) || id == edgeGroundId(setup_id);
}

}  // namespace stepmill
