#pragma once

#include "stepmill/toolpath/toolpath.h"

namespace stepmill::toolpath {

/// A finishing cut is no deeper than this many diameters, however thin it is.
inline constexpr double kDeepestFinishDiameters = 2;

/// The work of a finishing pass along walls.
struct WallTask {
    /// Its free centres are all those of the cutter. From its `cleared_centres` the disc meets no material at
    /// any depth. Its `centres`, entries and rings are not used.
    const ClearingTask& clearing;
    Region left;              ///< part of the target: the strip along the walls to be taken off
    double allowance_mm = 0;  ///< its width
};

/// Depths of cut of a finishing pass: as few as keep the chip's cross-section, allowance x depth, to that of
/// roughing, step-over x step-down, and the depth to the flutes and kDeepestFinishDiameters.
int finishingDepths(double depth_mm, double allowance_mm, const ToolAssembly& tool,
                    const CuttingData& cutting);

/// One pass along the walls that still have material, at each of finishingDepths(): the boundary of the free
/// centres there, in climb direction, at the cutting feed. It begins and ends
/// - on a quarter circle tangent to the wall, half the cutter's radius wide or, where that is not free, half
///   of that and so on down to the allowance, from ground that is cleared;
/// - past an open edge straight along the wall, in air;
/// - where there is no room for a quarter circle, straight from cleared ground to the wall;
/// - where there is no cleared ground beside the wall either, straight down at the wall, and up from it.
/// Passes all round overlap by kOverlapMm. No moves where nothing is left.
/// \see docs/algorithms/finishing.md
Toolpath finishWalls(const WallTask& task, const ToolAssembly& tool, const CuttingData& cutting,
                     const Machine& machine, const Tolerances& tol);

/// A closed pass goes on past its start by this much, so that no mark stays where it began [mm].
inline constexpr double kOverlapMm = 0.5;

/// The part of a region that no move of the path at its floor sweeps; strips of a sliver do not count.
Region leftBy(const Toolpath& path, const Region& region, double floor_z_mm, double radius_mm,
              const Tolerances& tol);

}  // namespace stepmill::toolpath
