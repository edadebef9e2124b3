#pragma once

#include <optional>
#include <vector>

#include "layers/solid_mesh.h"

namespace stepmill::layers {

/// One facet crossed by the cutting plane, from where it is entered to where it is left.
struct Crossing {
    int triangle = -1;
    int face = -1;
    int side_in = -1;   ///< shared with the crossing before
    int side_out = -1;  ///< shared with the crossing after
    Vec2 from;          ///< on the flat facet
    Vec2 to;
};

/// Closed chains of crossed facets, material on the left; nothing if a chain does not close.
/// A node at the very height counts as above. O(triangles).
std::optional<std::vector<std::vector<Crossing>>> traceChains(const SolidMesh& mesh, double z_mm);

}  // namespace stepmill::layers
