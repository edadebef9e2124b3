#pragma once

#include <vector>

#include "layers/monotone_piece.h"
#include "stepmill/planar/box_tree.h"
#include "stepmill/planar/edge_index.h"

namespace stepmill::layers {

/// A region that is asked again and again what of it lies somewhere. No boolean is computed for that.
///
/// Build O(n) for n edges. Immutable; safe to share between threads.
class IndexedRegion {
  public:
    explicit IndexedRegion(const Region& region);

    const std::vector<MonotonePiece>& pieces() const { return pieces_; }
    const EdgeIndex& edges() const { return edges_; }
    Box2 box() const { return tree_.box(); }
    /// Of the region in the box [mm2]; exact but for rounding. O(pieces at the box's heights and right of its
    /// left side).
    double areaIn(const Box2& box) const;
    /// Is p inside? On the boundary either answer. O(log n + pieces at its height on its right).
    bool holds(const Vec2& p) const;
    /// Is p outside and farther than that from the region?
    bool isBeyond(const Vec2& p, double by_mm) const;
    /// Is p inside and farther than that from the boundary?
    bool isDeep(const Vec2& p, double by_mm) const;

  private:
    std::vector<MonotonePiece> pieces_;
    BoxTree tree_;
    EdgeIndex edges_;
};

}  // namespace stepmill::layers
