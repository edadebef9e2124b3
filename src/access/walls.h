#pragma once

#include <vector>

#include "stepmill/access/access.h"
#include "stepmill/planar/edge_index.h"

namespace stepmill::access {

/// The walls of a feature that a cutter must not touch, and the room between them.
class Walls {
  public:
    explicit Walls(const FeatureGround& ground);

    /// The edges of the walls.
    const std::vector<Edge>& edges() const { return walls_.edges(); }
    /// Does a disc there clear all walls (to within `slack_mm`), lie outside material, and touch the target?
    bool discFits(const Vec2& centre, double radius_mm, double slack_mm) const;
    /// Distance to the nearest wall [mm].
    double clearance(const Vec2& p) const { return walls_.distanceTo(p); }
    /// Inside corners that are arcs.
    std::vector<Arc> insideArcs() const;

  private:
    bool walled_in_;
    const Region& target_;
    const Region& material_;  ///< the obstruction; unused when walled in
    EdgeIndex walls_;
};

/// A narrowest place of the room: a free disc that touches two walls on opposite sides.
struct Neck {
    double width_mm = 0;
    Vec2 at = Vec2::Zero();
};

/// All necks up to that width, ordered by width, then y, then x. Parallel walls have one, in their middle.
/// O(n^2) pairs of edges; most pairs are rejected by their boxes.
std::vector<Neck> findNecks(const Walls& walls, double widest_mm, const Tolerances& tol);

}  // namespace stepmill::access
