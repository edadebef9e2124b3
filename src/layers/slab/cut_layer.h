#pragma once

#include <map>
#include <string>
#include <vector>

#include "layers/slab/slab_facets.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/setup/setup.h"

namespace stepmill::layers {

/// A layer with what the books need beside it.
struct CutLayer {
    Layer layer;
    bool soft_top = false;             ///< no plane and no end of the stock lies at its top
    bool raw_stock_upright = true;     ///< before earlier setups cut it
    double shared_air_mm3 = 0;         ///< of `stock_air_mm3`: where the stock is that of a thicker slab
    double part_volume_mm3 = 0;        ///< of the solid itself
    std::map<int, FaceShare> leaning;  ///< what leans in the slab, by face
    /// What the part region holds of cones of holes beyond the part at any height of the slab, by face [mm3].
    std::map<int, double> in_cones_mm3;
    std::vector<std::string> remarks;

    double inCones_mm3() const;
};

/// Volume of the slab's part region that is no material [mm3].
double hiddenVolume(const CutLayer& cut);

/// Makes the slabs' volumes add up to the solid's: what facets missed belongs to the leaning slabs. A
/// difference that matters is a remark.
void closeBooks(std::vector<CutLayer>& cuts, const Setup& setup, const Tolerances& tol,
                std::vector<std::string>& remarks);

/// Fills in `sloped_volume_mm3` and `hidden` of every layer, shared out by the space over each face.
void shareHiddenVolume(std::vector<CutLayer>& cuts, const std::vector<FaceTrace>& traces);

/// The running union of the part from the top.
void castShadows(std::vector<CutLayer>& cuts, const Tolerances& tol);

/// Joins neighbouring slabs over soft levels where that costs nothing that matters:
/// - where no tool from above can tell: the lower slab's part adds nothing to the shadow;
/// - where the upper slab is thinner than `thinnest_slab_mm` and no removal component loses more than
///   `largest_hidden_share` of its area;
/// - where all slabs joined to one lose no more than `worthless_mm3` to air and hidden removal together.
/// The joined slab's part and stock are the unions, its shadow the lower one's.
/// \pre shadows are cast
std::vector<CutLayer> mergeSlabs(std::vector<CutLayer> cuts, double worthless_mm3,
                                 const SliceOptions& options, const Tolerances& tol);

}  // namespace stepmill::layers
