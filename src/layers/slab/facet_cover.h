#pragma once

#include <vector>

#include "layers/slab/slab_facets.h"
#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// Those of the facets that reach beyond the region by more than half the gouge budget, united. Plane
/// facets between straight edges as they are; others as hulls grown by the facets' sagitta: whatever the
/// true surface does near a facet, the hull holds it. Whether these reach beyond is asked at points on the
/// true surface, an eighth of a facet apart, that lie between the two heights, and of the flat facet.
Region facetsBeyond(const SolidMesh& mesh, const std::vector<SlabFacet>& facets, const Region& region,
                    double top_mm, double bottom_mm, const Tolerances& tol);

/// The facets that look up and have others that look down below them: over material that ends inside the
/// slab at both ends, which no section at the slab's ends shows.
std::vector<SlabFacet> facetsOverEnds(const std::vector<SlabFacet>& facets);

}  // namespace stepmill::layers
