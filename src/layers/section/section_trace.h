#pragma once

#include <vector>

#include "layers/mesh/solid_mesh.h"

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

/// Chains of crossed facets, material on the left. A node at the very height counts as above.
struct Chains {
    std::vector<std::vector<Crossing>> closed;
    std::vector<std::vector<Crossing>> open;  ///< that end where the facets leave a gap
};

/// O(facets of the faces that meet the height).
Chains traceChains(const SolidMesh& mesh, double z_mm);

}  // namespace stepmill::layers
