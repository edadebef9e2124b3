#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "layers/stock/scanned_area.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/part/part.h"
#include "stepmill/planar/region.h"
#include "stepmill/setup/prism.h"

namespace stepmill::layers {

/// All points p with normal . p <= reach_mm.
struct HalfPlane {
    Vec2 normal;
    double reach_mm;

    /// How far inside; negative beyond its edge [mm].
    double inside(const Vec2& p) const { return reach_mm - normal.dot(p); }
};

/// A prism whose axis is neither along a setup's axis nor across it.
///
/// Kept as a polygon inside the prism's outline, off it by Tolerances::chord_mm at arcs only, in the prism's
/// own coordinates, where the way straight up in the setup runs aslant over the ground and along the prism's
/// axis.
class AskewCut {
  public:
    /// \param to_setup  from the prism's coordinates to the setup's
    AskewCut(const Prism& prism, const Eigen::Isometry3d& to_setup);

    /// Nothing of the prism is wide enough to have a polygon within.
    bool empty() const { return outline_.empty(); }
    /// Outline heights in the setup [mm].
    /// \pre not empty
    double low_mm() const { return low_mm_; }
    double high_mm() const { return high_mm_; }
    /// Points over and under which the prism goes on at all heights between, in the setup's plane. The same
    /// height twice gives the section there. O(n log n) in the outline's edges.
    /// \param near  in the setup's plane; outside of it the answer may be less. Without it the whole plane
    Region between(double low_mm, double high_mm, const Tolerances& tol,
                   const std::optional<Box2>& near = std::nullopt) const;
    /// Points over or under which the prism is at some height between, in the setup's plane, as regions that
    /// may overlap. O(n).
    /// \param near  as above
    std::vector<Region> somewhere(double low_mm, double high_mm,
                                  const std::optional<Box2>& near = std::nullopt) const;
    /// The section at a height as its sides seen in the setup. O(edges).
    BandedPolygon at(double z_mm) const;

  private:
    /// A connected part of the outline.
    struct Piece {
        Region region;
        Box2 box;
    };
    /// Convex ground, and a box around its part of the outline or around what is asked for.
    struct Window {
        Box2 box;
        std::vector<HalfPlane> sides;
    };

    std::optional<Window> windowAt(double low_mm, double high_mm, double lowest_mm, double highest_mm,
                                   const std::optional<Box2>& near) const;
    Region toSetup(const Region& region, double z_mm) const;

    Region outline_;
    std::vector<Piece> pieces_;
    double top_mm_;
    double bottom_mm_;
    Eigen::Isometry3d to_setup_;
    Vec3 up_;  ///< the setup's axis in the prism's coordinates
    double low_mm_ = 1e300;
    double high_mm_ = -1e300;
};

}  // namespace stepmill::layers
