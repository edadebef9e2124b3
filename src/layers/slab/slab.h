#pragma once

#include <map>
#include <string>
#include <vector>

#include "layers/mesh/solid_mesh.h"
#include "layers/slab/slab_facets.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// A solid between two heights that are levels of it, or any heights between two such.
struct SlabCut {
    Region region;                     ///< everything the solid covers somewhere in the slab
    bool vertical = true;              ///< ... and at every height of it
    double volume_mm3 = 0;             ///< of the solid itself in the slab
    std::map<int, FaceShare> leaning;  ///< what leans in the slab, by face
    double mended_by_mm = 0;           ///< see Layer
    std::vector<std::string> remarks;
};

/// Cuts one slab.
///
/// Vertical walls: one section at mid-height. Walls that all lean the same way: the section at the wider
/// end, half a micrometre inside. Otherwise the union of both ends' sections, and of the hulls of those
/// facets that reach beyond it over material that ends inside the slab. The volume is that under the
/// facets, with what the surfaces bulge over them. A section that does not close costs accuracy, with a
/// remark, never the slab.
SlabCut cutSlab(const SolidMesh& mesh, double top_mm, double bottom_mm, const SliceOptions& options,
                const Tolerances& tol);

}  // namespace stepmill::layers
