#pragma once

#include <vector>

#include "layers/section/plane_curve.h"
#include "layers/section/section_trace.h"
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

}  // namespace stepmill::layers
