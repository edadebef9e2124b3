#pragma once

#include <vector>

#include "layers/solid_mesh.h"
#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// The part of a facet that lies in a slab, seen from above.
struct ProjectedFacet {
    std::vector<Vec2> corners;  ///< convex, either sense
    double normal_z = 0;        ///< of the true surface at its middle, outward
};

/// Clipped facets of the faces that are neither vertical nor horizontal.
std::vector<ProjectedFacet> slopedFacets(const SolidMesh& mesh, double top_mm, double bottom_mm);

/// Union of those facets that look up and reach farther than `slack_mm` beyond the region; empty if none
/// does. Every column of material that ends inside the slab ends at such a facet.
Region facetsBeyond(const std::vector<ProjectedFacet>& facets, const Region& region, double slack_mm,
                    const Tolerances& tol);

}  // namespace stepmill::layers
