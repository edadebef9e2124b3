#pragma once

#include <vector>

#include "layers/mesh/solid_mesh.h"
#include "stepmill/layers/face_trace.h"
#include "stepmill/part/face_graph.h"

namespace stepmill::layers {

/// Every face of the solid as the setup sees it, with its neighbours and, for leaning ones, their cause.
/// \param edges  of the same solid, faces in the same order
std::vector<FaceTrace> traceFaces(const SolidMesh& mesh, const std::vector<FaceEdge>& edges,
                                  const Tolerances& tol);

/// Neighbours of every face over the edges, by face.
std::vector<std::vector<FaceNeighbour>> neighboursOf(const std::vector<FaceEdge>& edges, std::size_t faces);

/// Fills in `cause` of the leaning faces.
void nameCauses(const SolidMesh& mesh, std::vector<FaceTrace>& traces);

}  // namespace stepmill::layers
