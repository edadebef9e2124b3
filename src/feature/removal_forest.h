#pragma once

#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/planar/region.h"

namespace stepmill::feature {

/// A connected piece of stock - shadow in one layer.
struct RemovalComponent {
    int layer = 0;
    Region region;
    double area_mm2 = 0;
    bool open = false;           ///< part of its boundary is the stock's own: a cutter can come in there
    bool inside_parent = false;  ///< lies within its only parent, as it always does in a box of stock
    bool left = false;           ///< no feature takes it: not worth a pass after earlier setups
    /// The full circle that it goes on with or begins: one above, with nothing between but what lies in it
    /// and air, or itself. A hole goes on like that where it crosses another. -1: none.
    int hole = -1;
    std::vector<int> parents;  ///< components of the layer above that it overlaps, or the next above air
    std::vector<int> children;
    /// Of its area that is stock half-way up the layer, where the stock's walls lean.
    double stock_share = 1;
    bool in_drill_point = false;  ///< `left` to a drill
};

/// What a setup removes, layer by layer from the top, in the order of components() within a layer.
struct RemovalForest {
    std::vector<RemovalComponent> components;
    std::vector<std::vector<int>> of_layer;
    std::vector<double> sliver_area_mm2;  ///< per layer: dropped, nowhere as wide as tol.sliver_mm
};

double volumeMm3(const RemovalComponent& component, const LayerStack& layers);

RemovalForest buildRemovalForest(const LayerStack& layers, const Tolerances& tol);

/// Unlinks components marked `left` from those that are not.
void dropLeft(RemovalForest& forest);

}  // namespace stepmill::feature
