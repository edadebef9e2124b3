#pragma once

#include "stepmill/access/access.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/plan/plan.h"

namespace stepmill {

/// Depths of cut that a tool takes for a height.
double depthsOf(double height_mm, const CuttingData& cutting);

/// What a depth of cut takes a mill on a planned level, estimated: as where the tool has a path on it, else
/// all over its centres at the step-over and along their boundary [s/mm2].
/// \param area  what the tool can do there
double secondsPerMm2(const PlannedFeature& level, const ToolAssembly& tool, const CuttingData& cutting,
                     const CutterArea& area);

/// What a level's steps take for their shares of some ground [s]. What they sweep beyond the target, in air,
/// counts for nothing.
double secondsOver(const PlannedFeature& level, const Region& ground, const Tolerances& tol);

}  // namespace stepmill
