#pragma once

#include <optional>

#include "stepmill/feature/measure.h"

namespace stepmill::feature {

/// The thinnest wall between the feature and an outside or another hollow of the part, found by rays from
/// its closed boundary through the part's region, layer by layer.
std::optional<WallThickness> thinnestWall(const Feature& feature, const LayerStack& layers,
                                          const Tolerances& tol);

}  // namespace stepmill::feature
