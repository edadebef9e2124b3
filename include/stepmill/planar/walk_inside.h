#pragma once

#include <optional>

#include "stepmill/planar/indexed_region.h"

namespace stepmill {

/// Tells of a way, edge by edge, whether a disc that goes along it meets a region. Where the way stays off
/// the boundary it stays inside or outside: the region is asked only where that may have changed.
class WalkInside {
  public:
    /// Keeps it.
    explicit WalkInside(const IndexedRegion& region) : region_(&region) {}

    /// Does the disc come nearer to the boundary than its radius, or is its centre inside?
    bool meets(const Edge& way, double radius_mm) {
        if (region_->boundary().anyNearer(way, radius_mm)) return true;
        const bool inside = isInside(way);
        // A disc of no width may cross the boundary unseen.
        if (radius_mm <= 0) end_.reset();
        return inside;
    }

    /// Is it inside?
    /// \pre the way does not meet the boundary
    bool isInside(const Edge& way) {
        if (!end_ || *end_ != way.from)
            inside_ = region_->boundary().box().contains(way.from) && region_->contains(way.from);
        end_ = way.segment.to;
        return inside_;
    }

  private:
    const IndexedRegion* region_;
    std::optional<Vec2> end_;  ///< of the last edge, where it stayed off the boundary
    bool inside_ = false;      ///< was it?
};

}  // namespace stepmill
