#pragma once

#include <optional>
#include <vector>

#include "stepmill/planar/edge_index.h"
#include "stepmill/planar/indexed_region.h"
#include "stepmill/toolpath/finish_walls.h"

namespace stepmill::toolpath {

/// A way to or from a pass at depth: to where it ends, or from where it starts.
struct Lead {
    Path path;
    bool through_material = false;  ///< there is no way: straight down
};

/// Finds ways between cleared ground and a pass along a wall; see finishWalls() for their order.
class WallLeads {
  public:
    /// Keeps `task` and `tol`.
    WallLeads(const WallTask& task, double radius_mm, const Tolerances& tol);

    /// To p, where a pass begins in that direction.
    Lead into(const Vec2& p, const Vec2& along) const;
    /// From p, where a pass ends in that direction. A path without edges: straight up.
    Path from(const Vec2& p, const Vec2& along) const;

    /// Radii of quarter circles, in the order they are tried.
    std::vector<double> radii() const;
    /// The quarter circle that ends at p in that direction; nothing where it is not free.
    std::optional<Path> arcInto(const Vec2& p, const Vec2& along, double lead_mm) const;
    /// The quarter circle that leaves p in that direction; nothing where it is not free.
    std::optional<Path> arcFrom(const Vec2& p, const Vec2& along, double lead_mm) const;

  private:
    bool isFree(const Edge& way) const;
    bool isFree(const Path& way) const;
    bool isAir(const Vec2& p) const;
    std::optional<Vec2> airBeside(const Vec2& p, const Vec2& along) const;

    const WallTask& task_;
    double radius_mm_;
    const Tolerances& tol_;
    IndexedRegion target_;
    IndexedRegion cleared_;  ///< centres
    IndexedRegion obstruction_;
    std::vector<IndexedRegion> kept_;
};

}  // namespace stepmill::toolpath
