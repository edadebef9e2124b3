#pragma once

#include <vector>

#include "stepmill/access/access.h"

namespace stepmill::access {

/// A boundary edge the cutter must keep clear of.
struct WallEdge {
    Vec2 from;
    Segment segment;
    Box2 box;
};

/// What bounds the room of a cutter in a feature, and what room it is.
class Walls {
  public:
    explicit Walls(const FeatureGround& ground);

    const std::vector<WallEdge>& edges() const { return edges_; }
    /// Is a disc there clear of all walls (within `slack_mm`), outside material and at work on the target?
    bool discFits(const Vec2& centre, double radius_mm, double slack_mm) const;
    /// Distance to the nearest wall [mm].
    double clearance(const Vec2& p) const;
    /// Inside corners that are arcs.
    std::vector<Arc> insideArcs() const;

  private:
    bool clear(const Vec2& centre, double radius_mm) const;

    bool walled_in_;
    const Region& target_;
    const Region& material_;  ///< the obstruction; unused when walled in
    std::vector<WallEdge> edges_;
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
