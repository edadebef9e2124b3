#pragma once

#include "stepmill/toolpath/step_over.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill::toolpath {

/// Angle of descents through material: the cutting data's, else a usual one.
double rampAngleDeg(const CuttingData& cutting);
/// The same in radians.
double rampAngle(const CuttingData& cutting);

/// More depths of cut than this are no way to clear anything; a path of them would not fit in memory.
inline constexpr int kMostDepths = 1000;

/// As few equal depths of cut as the step-down allows, at least one; without a step-down one.
/// \throws Error(InvalidCatalog) for more than kMostDepths
int depthsFor(double depth_mm, double step_down_mm);

/// A path without moves from the task's top to its floor in that many depths, with the cutting data's feeds
/// within the machine's.
Toolpath pathFrame(const ClearingTask& task, int depths, double radius_mm, const CuttingData& cutting,
                   const Machine& machine);

/// What a turn of a helix takes a length and pitch [mm]: as wide as the cutter or, on a circle narrower than
/// that, more, since the cutter's rim goes farther than its middle.
double helixWidth(double circle_radius_mm, double radius_mm);

/// Rapids that come down to a hole stop so far over its top [mm].
inline constexpr double kOverHoleMm = 1.0;

/// Is a top the stock's own? z = 0 is its height by the plan; a stock that may be larger goes higher.
bool isRawTop(double z_mm);

/// Height of the floor of a depth of cut, counted from 1; 0: the top.
double floorOf(const ClearingTask& task, const Toolpath& frame, int depth);

}  // namespace stepmill::toolpath
