#pragma once

#include <vector>

#include "layers/mesh/solid_mesh.h"
#include "stepmill/layers/face_trace.h"

namespace stepmill::layers {

/// Every face of the solid as the setup sees it, with its neighbours and, for leaning ones, their cause.
std::vector<FaceTrace> traceFaces(const SolidMesh& mesh, const Tolerances& tol);

/// Neighbours of every face over the solid's edges.
std::vector<std::vector<FaceNeighbour>> findNeighbours(const SolidMesh& mesh);

/// Fills in `cause` of the leaning faces.
void nameCauses(const SolidMesh& mesh, std::vector<FaceTrace>& traces);

}  // namespace stepmill::layers
