#pragma once

#include <vector>

#include "layers/section/section_trace.h"

namespace stepmill::layers {

/// Where the edge (or facet side) crosses the height: on the true curve if the side lies on one.
Vec2 pointOnEdge(const SolidMesh& mesh, int side, double z_mm);

/// Points on the face's surface at the height, along a chain of its facets: dense enough that arcs through
/// them follow the surface to far less than a micrometre where the facets follow it to their sagitta.
std::vector<Vec2> pointsOnSurface(const SolidMesh& mesh, const std::vector<Crossing>& crossings, double z_mm);

}  // namespace stepmill::layers
