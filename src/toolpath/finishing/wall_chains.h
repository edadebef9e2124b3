#pragma once

#include <vector>

#include "stepmill/planar/edge_index.h"
#include "stepmill/toolpath/finish_walls.h"

namespace stepmill::toolpath {

/// Finds the stretches of a boundary along which walls still have material.
class WallChains {
  public:
    WallChains(const WallTask& task, double radius_mm, const Tolerances& tol);

    /// The whole loop, or its stretches on which a disc reaches material that is left. A gap between two
    /// stretches belongs to them where lifting over it would cost more than going along it. In climb
    /// direction.
    std::vector<Path> along(const Loop& loop) const;

  private:
    bool isNeeded(const Edge& edge) const;

    EdgeIndex left_edges_;
    double radius_mm_;
    const Tolerances& tol_;
};

}  // namespace stepmill::toolpath
