#pragma once

#include <optional>
#include <vector>

#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill {

/// Adaptive ways over cleared ground go so far over it where the library does not say [mm].
inline constexpr double kUsualAdaptiveLiftMm = 0.2;

/// The cutting data for roughing at constant engagement: the library's own set or, where it has none, one
/// that removes no more in a minute than step-over, step-down and feed do, over as many equal depths as the
/// flutes ask for. Its feed makes chips as thick as theirs, up to kMostChipThinning.
/// \param depth_mm  of what is cut
/// \return  step_down_mm is the depth of one cut. Nothing to derive where the flutes allow no fewer depths, or
///          where no step-over from 5 to 25 % of the diameter does.
/// \see docs/algorithms/adaptive.md
std::optional<CuttingData> adaptiveCutting(const ToolAssembly& tool, const CuttingData& cutting,
                                           double depth_mm);

/// What is chosen from without constant engagement: the others that were asked for, or all others.
std::vector<Pattern> notAdaptive(std::vector<Pattern> patterns);

/// Feed of adaptive ways over cleared ground: as fast as the machine feeds, and no faster than its rapids.
double glideFeedMmPerMin(const Machine& machine);

/// Of the rim, in a straight cut as wide as the step-over [rad].
double engagementRad(double radius_mm, double step_over_mm);

}  // namespace stepmill
