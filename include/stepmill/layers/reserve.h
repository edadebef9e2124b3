#pragma once

#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/setup/prism.h"

namespace stepmill {

/// The stack with its layers parted at these heights, too. Both parts of a layer have its regions; volumes
/// that its leaning walls hide are shared out by height.
/// \param heights_mm  those that are a level but for rounding, or out of the stack, part nothing
LayerStack partedAt(LayerStack layers, const std::vector<double>& heights_mm);

/// The stack with stock that must stand in this setup for a later one [whole-part.md].
///
/// To a tool from above it is as good as part: the shadows of a prism's layers and of all below hold it.
/// Layers part where a prism begins or ends.
/// \param reserve  in setup coordinates
/// \note O(layers) unions.
LayerStack withReserve(LayerStack layers, const std::vector<Prism>& reserve, const Tolerances& tol);

}  // namespace stepmill
