#pragma once

#include <optional>

#include "stepmill/planar/edge_index.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// Tells of a way, edge by edge, whether a disc that goes along it meets a region. Where the way stays off
/// the boundary it stays inside or outside: the region is asked only where that may have changed.
class WalkInside {
  public:
    /// Keeps both.
    WalkInside(const Region& region, const EdgeIndex& edges) : region_(&region), edges_(&edges) {}

    /// Does the disc come nearer to the boundary than its radius, or is its centre inside?
    bool meets(const Edge& way, double radius_mm) {
        if (edges_->anyNearer(way, radius_mm)) return true;
        const bool inside = isInside(way);
        // A disc of no width may cross the boundary unseen.
        if (radius_mm <= 0) end_.reset();
        return inside;
    }

    /// Is it inside?
    /// \pre the way does not meet the boundary
    bool isInside(const Edge& way) {
        if (!end_ || *end_ != way.from)
            inside_ = edges_->box().contains(way.from) && contains(*region_, way.from);
        end_ = way.segment.to;
        return inside_;
    }

  private:
    const Region* region_;
    const EdgeIndex* edges_;
    std::optional<Vec2> end_;  ///< of the last edge, where it stayed off the boundary
    bool inside_ = false;      ///< was it?
};

}  // namespace stepmill
