#pragma once

#include <optional>

#include "layers/mesh/solid_mesh.h"
#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// The solid's section at one height: lines where it meets planes, arcs where it meets faces turned about
/// a vertical axis, fitted lines and arcs (see fitSafeSide) elsewhere. Material on the left.
///
/// Which faces follow one another comes from the crossed facets; joints are the edges' crossings with the
/// plane. A node exactly at the height counts as above it, so that a section at a vertex is that just
/// below it. Nothing when a chain of facets does not close or the loops make no valid region.
std::optional<Region> exactSection(const SolidMesh& mesh, double z_mm, const Tolerances& tol);

}  // namespace stepmill::layers
