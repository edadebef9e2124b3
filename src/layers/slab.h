#pragma once

#include <string>
#include <vector>

#include "layers/solid_mesh.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// A solid between two heights that are levels of it, or any heights between two such.
struct SlabCut {
    Region region;          ///< everything the solid covers somewhere in the slab
    bool vertical = true;   ///< ... and at every height of it
    double volume_mm3 = 0;  ///< of the solid itself in the slab
    std::vector<std::string> remarks;
};

/// Cuts one slab.
///
/// Vertical walls: one section at mid-height. Walls that all lean the same way: the section at the wider
/// end, half a micrometre inside. Otherwise the union of both ends' sections, and of the projections of
/// those facets that reach beyond it. The volume is Gauss' rule over three sections.
/// \throws Error(GeometryKernel) naming the height if no section near it can be closed.
SlabCut cutSlab(const SolidMesh& mesh, double top_mm, double bottom_mm, const SliceOptions& options,
                const Tolerances& tol);

/// The section at a height; where none closes, of a height within a tenth of the slab next to it, else of
/// the facets, with a remark.
Region mendedSection(const SolidMesh& mesh, double z_mm, double top_mm, double bottom_mm,
                     const Tolerances& tol, std::vector<std::string>& remarks);

/// The union; one of the two itself where it covers the other, so that arcs and walls stay as they are.
Region uniteKeeping(const Region& a, const Region& b, const Tolerances& tol);

}  // namespace stepmill::layers
