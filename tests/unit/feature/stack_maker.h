#pragma once

#include <vector>

#include "stepmill/layers/layer_stack.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::test {

/// A layer of a stack under construction: its bottom and the part in it.
struct Slab {
    double bottom_z_mm = 0;
    Region part;
};

/// A horizontal face of the part.
inline FaceTrace floorFace(double z_mm, const Region& region) {
    FaceTrace trace;
    trace.stand = FaceStand::Floor;
    trace.top_z_mm = trace.bottom_z_mm = z_mm;
    trace.region = region;
    return trace;
}

/// A stack with vertical walls in a box of stock whose top is z = 0; shadows, floors and volumes follow from
/// it.
inline LayerStack makeStack(const Region& stock, const std::vector<Slab>& slabs, const Tolerances& tol = {}) {
    LayerStack stack;
    stack.setup_id = "S1";
    double top_z_mm = 0;
    Region shadow;
    for (const Slab& slab : slabs) {
        Layer layer;
        layer.top_z_mm = top_z_mm;
        layer.bottom_z_mm = slab.bottom_z_mm;
        layer.part = slab.part;
        layer.stock = stock;
        const Region floor = subtract(slab.part, shadow, tol);
        if (!floor.empty()) {
            stack.traces.push_back(floorFace(top_z_mm, floor));
            stack.traces.back().face = static_cast<int>(stack.traces.size()) - 1;
        }
        if (shadow.empty())
            shadow = slab.part;
        else if (!slab.part.empty())
            shadow = unite(shadow, slab.part, tol);
        layer.shadow = shadow;
        stack.stock_volume_mm3 += area(stock) * layer.height_mm();
        stack.part_volume_mm3 += area(slab.part) * layer.height_mm();
        top_z_mm = slab.bottom_z_mm;
        stack.layers.push_back(std::move(layer));
    }
    stack.stock_bottom_z_mm = top_z_mm;
    return stack;
}

}  // namespace stepmill::test
