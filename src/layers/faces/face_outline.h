#pragma once

#include "layers/mesh/solid_mesh.h"
#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// What a face covers seen from above, from its edges; empty if its outline folds over itself.
/// \pre the face looks up everywhere or down everywhere
Region outlineFromAbove(const SolidMesh& mesh, int face, const Tolerances& tol);

/// Where a vertical face stands, material on the left, from end to end over all heights; closed where it
/// goes all round.
Path footprintOf(const SolidMesh& mesh, int face, const Tolerances& tol);

}  // namespace stepmill::layers
