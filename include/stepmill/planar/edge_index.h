#pragma once

#include <limits>
#include <vector>

#include "stepmill/planar/box_tree.h"
#include "stepmill/planar/edge.h"

namespace stepmill {

/// Edges that are asked again and again what lies near a point or another edge.
///
/// Build O(n), a query O(log n) on ordinary boundaries. The answers are those of a search through all edges.
/// Immutable; safe to share between threads.
class EdgeIndex {
  public:
    static constexpr double kFarthestMm = std::numeric_limits<double>::infinity();

    EdgeIndex() = default;
    explicit EdgeIndex(std::vector<Edge> edges);
    explicit EdgeIndex(const Path& path);
    explicit EdgeIndex(const Region& region);

    const std::vector<Edge>& edges() const { return edges_; }
    bool empty() const { return edges_.empty(); }
    /// Around all edges; empty without edges.
    Box2 box() const { return tree_.box(); }

    /// Distance from p to the nearest edge [mm], or `limit_mm` where all are farther away.
    double distanceTo(const Vec2& p, double limit_mm = kFarthestMm) const;
    /// Least separation from an edge [mm], or `limit_mm` where all are farther away.
    double distanceTo(const Edge& edge, double limit_mm = kFarthestMm) const;
    /// Is some edge nearer than `distance_mm`?
    bool anyNearer(const Vec2& p, double distance_mm) const;
    bool anyNearer(const Edge& edge, double distance_mm) const;

    /// Calls `visit(edge)` for the edges whose box intersects `box`, in their order.
    template <typename Visit>
    void forEachIn(const Box2& box, const Visit& visit) const {
        tree_.forEachNear(box, [&](std::size_t i) { visit(edges_[i]); });
    }

  private:
    template <typename Shape, typename Distance>
    double least(const Shape& shape, const Distance& distance, double limit_mm, bool first_will_do) const;

    std::vector<Edge> edges_;
    BoxTree tree_;
};

/// Shares of an edge's length at which others meet it, ascending, with its ends 0 and 1; equal ones may
/// repeat.
std::vector<double> sharesWhereMet(const Edge& edge, const EdgeIndex& others);

}  // namespace stepmill
