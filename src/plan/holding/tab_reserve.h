#pragma once

#include <string>

#include "stepmill/catalog/tool.h"
#include "stepmill/layers/layer_stack.h"
#include "stepmill/setup/prism.h"
#include "stepmill/setup/setup.h"

namespace stepmill {

/// Stock that stays in a setup so that its part stays in place: a frame, as high as the stock, beside the
/// channel that a mill clears round the part, and tabs at the bottom of the channel that tie the part to it.
///
/// The channel is a fifth wider than its mill. Tabs are spread evenly along the part's outline, at its
/// straight stretches where these are near.
/// \return the frame, then the tabs
/// \throws Error(Usage) where the part does not stand on the stock's bottom, no mill reaches down to it, or
/// the stock leaves no frame
CutPrisms tabbedFrame(const Setup& setup, const SliceOptions& slicing, const ToolLibrary& library,
                      const std::string& material, const Tolerances& tol);

}  // namespace stepmill
