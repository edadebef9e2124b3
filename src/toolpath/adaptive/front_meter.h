#pragma once

#include <vector>

#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/indexed_region.h"
#include "stepmill/planar/region.h"
#include "stepmill/toolpath/cut_ground.h"

namespace stepmill::toolpath {

/// How much of the cutter's rim a pass may have in material.
struct EngagementLimit {
    double width_mm = 0;   ///< across the direction of travel
    double angle_rad = 0;  ///< of the rim
};

/// The limit of a cutter at its step-over: that of a straight cut so wide.
EngagementLimit engagementLimit(double radius_mm, double step_over_mm);

/// A place of a pass.
struct FrontPlace {
    double along_mm = 0;  ///< from the pass' start
    double width_mm = 0;  ///< of the rim that meets material, grazes and all, across the direction of travel
};

/// What a pass does to the rim.
struct FrontCut {
    double worst_share = 0;  ///< its greatest engagement, as a multiple of the limit
    std::vector<FrontPlace> places;
};

/// Measures passes against the material that is left beside the ground that a disc clears from some centres.
class FrontMeter {
  public:
    /// \param cleared  the centres: the disc meets no material there
    FrontMeter(const ClearanceDiagram& cleared, const Region& target, double radius_mm,
               const EngagementLimit& limit, const Tolerances& tol);

    /// Looked for no further where half as much again as the limit is found. Exact at places a twentieth of
    /// the radius apart, five on each edge at least.
    FrontCut measure(const Path& pass) const;

    /// Of a cutter at that place, as a multiple of the limit.
    double engagementAt(const Vec2& at, const Vec2& along) const;

    const IndexedRegion& cleared() const { return cleared_; }

  private:
    /// \return  the width of the rim that meets material
    double look(const Vec2& at, const Vec2& along, FrontCut& into) const;

    IndexedRegion cleared_;
    IndexedRegion material_;  ///< what is left
    IndexedRegion deep_;      ///< of that what no graze reaches
    double radius_mm_;
    EngagementLimit limit_;
};

}  // namespace stepmill::toolpath
