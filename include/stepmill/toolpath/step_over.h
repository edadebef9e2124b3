#pragma once

#include "stepmill/catalog/tool.h"

namespace stepmill::toolpath {

/// The step-over that passes keep [mm]: the cutting data's, but no wider than the radius, so that rings leave
/// nothing between them.
double usedStepOver(const CuttingData& cutting, double radius_mm);

}  // namespace stepmill::toolpath
