#pragma once

#include "feature/removal_forest.h"

namespace stepmill::feature {

/// Marks what earlier setups left and this one does not finish either (`RemovalComponent::left`): steps on
/// walls that lean to this axis too, cusps of corners, facets of the stock. Only on stock that was cut
/// before.
///
/// Components that touch each other are a lump. Those that finish a face of the part (most of their wall
/// stands upright on one, or much of their floor lies on one), or lie over such, are worth cutting where
/// their lump finishes much of some face or plugs a hole and is no crumb. All others are in lumps of
/// `kLumpShare` of all there is to remove.
void markLeftovers(RemovalForest& forest, const LayerStack& layers, const Tolerances& tol);

}  // namespace stepmill::feature
