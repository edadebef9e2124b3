#pragma once

#include "stepmill/planar/indexed_region.h"
#include "stepmill/planar/region.h"
#include "stepmill/toolpath/cut_ground.h"

namespace stepmill::toolpath {

/// Swept ground counts as narrower by this share of the radius, as in proofs of cuts.
inline constexpr double kProofCuspShare = 0.005;
/// How much of the cutter's rim a pass may have in material.
struct EngagementLimit {
    double width_mm = 0;   ///< across the direction of travel
    double angle_rad = 0;  ///< of the rim
};

/// The limit of a cutter at its step-over: that of a straight cut so wide.
EngagementLimit engagementLimit(double radius_mm, double step_over_mm);

/// What a pass does to the rim.
struct FrontCut {
    double worst_share = 0;  ///< its greatest engagement, as a multiple of the limit
    bool cuts = false;       ///< it meets material somewhere, if only to graze it
};

/// Measures passes against the ground that is clear before them: all that a disc reaches from `cleared`.
class FrontMeter {
  public:
    /// Keeps its arguments. \param cleared  centres from which the disc meets no material
    FrontMeter(const Region& cleared, const IndexedRegion& target, double radius_mm,
               const EngagementLimit& limit);

    /// Looked for no further where half as much again as the limit is found. Exact at places a tenth of the
    /// radius apart, five on each edge at least.
    FrontCut measure(const Path& pass) const;

  private:
    void look(const Vec2& at, const Vec2& along, FrontCut& into) const;

    IndexedRegion cleared_;
    const IndexedRegion& target_;
    double radius_mm_;
    EngagementLimit limit_;
};

}  // namespace stepmill::toolpath
