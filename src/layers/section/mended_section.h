#pragma once

#include <string>
#include <vector>

#include "layers/mesh/solid_mesh.h"
#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// A section and how it was come by.
struct MendedSection {
    Region region;
    double z_mm = 0;        ///< where it was cut
    double exceeds_mm = 0;  ///< how far it may reach beyond the true section at that height [mm]
    bool moved = false;     ///< cut farther from the height asked for than the slab's inset
    std::string remark;     ///< empty if nothing had to be mended
};

/// The section at a height; where none closes, of a height within a tenth of the slab next to it; else a
/// region that surely holds the section (see hullSection). Never fails.
/// \param inset_mm  how far the height may move without a word
MendedSection mendedSection(const SolidMesh& mesh, double z_mm, double top_mm, double bottom_mm,
                            double inset_mm, const Tolerances& tol);

}  // namespace stepmill::layers
