#pragma once

#include <vector>

#include "stepmill/access/access.h"
#include "stepmill/planar/edge_index.h"

namespace stepmill::access {

/// The walls that a cutter must not touch in a feature, and the room between them.
class Walls {
  public:
    explicit Walls(const FeatureGround& ground);

    /// The boundary edges the cutter must keep clear of.
    const std::vector<Edge>& edges() const { return walls_.edges(); }
    /// Is a disc there clear of all walls (within `slack_mm`), outside material and at work on the target?
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

/// Two walls that face each other across a free disc which touches both: a minimum of clearance along the way
/// between them.
struct Neck {
    double width_mm = 0;
    Vec2 at = Vec2::Zero();
};

/// All necks up to that width, by width, then y, then x. Of parallel walls the middle alone.
/// O(n^2) pairs of edges; most end at the first look.
std::vector<Neck> findNecks(const Walls& walls, double widest_mm, const Tolerances& tol);

}  // namespace stepmill::access
