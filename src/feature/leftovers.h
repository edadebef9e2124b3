#pragma once

#include "feature/removal_forest.h"

namespace stepmill::feature {

/// Marks what earlier setups left and this one does not finish either (`RemovalComponent::left`): steps on
/// walls that lean to this axis too, cusps of corners, facets of the stock. Only on stock that was cut
/// before.
///
/// A component is worth cutting where it finishes a face of the part (most of its wall stands upright on one,
/// or much of its floor lies on one), or where one that is lies below it. What does neither is worth it only
/// in lumps, components that touch each other counted together, of `kLumpShare` of all there is to remove.
void markLeftovers(RemovalForest& forest, const LayerStack& layers, const Tolerances& tol);

}  // namespace stepmill::feature
