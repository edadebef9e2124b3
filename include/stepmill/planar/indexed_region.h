#pragma once

#include "stepmill/planar/edge_index.h"
#include "stepmill/planar/region.h"

namespace stepmill {

/// A region that is asked again and again whether points lie in it.
///
/// Build O(n), a question O(log n) on ordinary boundaries. The answers are those of contains(). Immutable;
/// safe to share between threads.
class IndexedRegion {
  public:
    IndexedRegion() = default;
    explicit IndexedRegion(const Region& region) : boundary_(region) {}

    const EdgeIndex& boundary() const { return boundary_; }

    /// Is p inside or on the boundary?
    bool contains(const Vec2& p) const;
    /// Is p inside or nearer to the boundary than that?
    bool isNear(const Vec2& p, double distance_mm) const {
        return contains(p) || boundary_.anyNearer(p, distance_mm);
    }
    /// Does a way go inside or come nearer to the boundary than that?
    /// \pre distance_mm > 0
    bool isNear(const Edge& way, double distance_mm) const {
        return boundary_.anyNearer(way, distance_mm) || contains(way.to());
    }

  private:
    EdgeIndex boundary_;
};

}  // namespace stepmill
