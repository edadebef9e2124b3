#pragma once

#include <vector>

#include "layers/section_trace.h"
#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// A stretch of a section on one face.
struct FaceRun {
    const MeshFace* face = nullptr;
    std::vector<Crossing> crossings;
    bool whole_loop = false;  ///< the section closes on this face alone
};

/// The exact loop for a closed chain of runs; no segments where it is too small to matter.
Loop joinRuns(const SolidMesh& mesh, const std::vector<FaceRun>& runs, double z_mm, const Tolerances& tol);

/// A closed loop of segments (each from the end of the one before, cyclic): pieces of nothing dropped,
/// pieces of one line or circle merged, begun at its least point; whole circles as two half arcs.
Loop tidyLoop(std::vector<Segment> segments);

/// Loops in an order that depends on their points alone.
void sortLoops(Region& region);

}  // namespace stepmill::layers
