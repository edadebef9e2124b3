#pragma once

#include <optional>

#include "layers/mesh/solid_mesh.h"
#include "layers/slab/slab.h"
#include "stepmill/setup/setup.h"

namespace stepmill::layers {

/// A setup's stock before any setup cut it: an upright box, or facets of a solid.
class RawStock {
  public:
    RawStock(const Setup& setup, const Tolerances& tol);

    /// Nothing for an upright box.
    const std::optional<SolidMesh>& mesh() const { return mesh_; }
    /// The upright box; empty where there is a mesh.
    const Region& box() const { return box_; }

  private:
    std::optional<SolidMesh> mesh_;
    Region box_;
};

}  // namespace stepmill::layers
