#pragma once

#include <array>
#include <map>
#include <vector>

#include "layers/mesh/solid_mesh.h"
#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// The part of a facet that lies in a slab.
struct SlabFacet {
    int face = -1;
    int triangle = -1;
    std::array<Vec2, 5> corner;  ///< seen from above; convex, either sense
    int corners = 0;
    double normal_z = 0;       ///< of the true surface at its middle, outward
    double plan_area_mm2 = 0;  ///< seen from above; negative where the facet looks down
    double mean_z_mm = 0;      ///< over that area
    double low_mm = 0;
    double high_mm = 0;
    /// No higher than rounding: what merging of levels leaves of a face beyond its end, and facets that lie
    /// in one of their face's level curves. Has volume over it, but leans nowhere.
    bool thin = false;
};

/// Clipped facets of the faces that are neither vertical nor horizontal.
std::vector<SlabFacet> slopedFacets(const SolidMesh& mesh, double top_mm, double bottom_mm);

/// Volume of the solid in the slab: that of the facets, by Gauss' theorem, and of what lies between them
/// and the curved surfaces. No section is cut for it.
double volumeInSlab(const SolidMesh& mesh, const std::vector<SlabFacet>& facets, double top_mm,
                    double bottom_mm);

/// What a face shows of itself in a slab, seen from above and from below. Adds up over slabs.
struct FaceShare {
    double up_mm2 = 0;      ///< plan area of what looks up
    double down_mm2 = 0;    ///< ... and down
    double moment_mm3 = 0;  ///< of the heights: up counts positive, down negative

    void add(const FaceShare& other);
    /// Empty space of the slab over the face, under it, or enclosed by it. [mm3]
    double space(double top_mm, double bottom_mm) const;
};
std::map<int, FaceShare> sharesOfFaces(const std::vector<SlabFacet>& facets);

}  // namespace stepmill::layers
