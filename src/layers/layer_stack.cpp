// Questions to a layer stack.

#include "stepmill/layers/layer_stack.h"

#include "layers/slab.h"
#include "stepmill/core/error.h"

namespace stepmill {

Region LayerStack::partAbove(double z_mm, const Tolerances& tol) const {
    // The shadow of a layer is the union of it and all above; the lowest layer that reaches above z has it.
    const Layer* lowest = nullptr;
    for (const Layer& layer : layers)
        if (layer.top_z_mm > z_mm + tol.linear_mm) lowest = &layer;
    return lowest ? lowest->shadow : Region{};
}

const Region& LayerStack::stockAt(double z_mm) const {
    STEPMILL_CHECK(!layers.empty(), "a layer stack has at least one layer");
    static const Region kNothing;
    if (z_mm > stock_top_z_mm || z_mm < stock_bottom_z_mm) return kNothing;
    for (const Layer& layer : layers)
        if (z_mm > layer.bottom_z_mm) return layer.stock;
    return layers.back().stock;
}

}  // namespace stepmill
