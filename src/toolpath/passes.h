#pragma once

#include <vector>

#include "stepmill/toolpath/toolpath.h"

namespace stepmill::toolpath {

/// One cut of a layer: a closed ring or what clipping has left of one, in climb direction.
struct Pass {
    Path path;
    bool closed = false;
    /// Index of the component of the free centres, hence of its entry.
    int component = 0;
    /// Count of step-overs from the boundary the family starts at.
    int level = 0;
    /// A disc at the start of an open pass meets no material: the cutter may come down there in air.
    bool starts_in_air = false;
    /// Passes that come before this one, so that it cuts no wider than the step-over.
    std::vector<int> after;
    /// Passes one step-over away: the straight link to them cuts no wider than the step-over.
    std::vector<int> neighbours;
};

/// The passes that clear the task's centres in one layer.
struct PassSet {
    std::vector<Region> components;  ///< of the free centres
    std::vector<Pass> passes;
};

/// The step-over as used: no wider than the radius, so that rings leave nothing between them.
double usedStepOver(const CuttingData& cutting, double radius_mm);

/// Contour-parallel passes [docs/algorithms/contour-parallel.md]. Every point of the target that a disc of
/// radius r reaches from task.centres lies within r of a pass, or has been cleared before.
PassSet contourParallel(const ClearingTask& task, const RingFamily& family, const Tolerances& tol);

}  // namespace stepmill::toolpath
