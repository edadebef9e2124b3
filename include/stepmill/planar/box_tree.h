#pragma once

#include <array>
#include <utility>
#include <vector>

#include "stepmill/planar/box.h"

namespace stepmill {

/// Boxes in a binary tree over their order, for items that follow each other along a boundary: neighbours in
/// the order are neighbours in the plane.
///
/// Items are named by their index. Build O(n); a query visits O(log n + found) boxes on ordinary boundaries.
/// Immutable; safe to share between threads.
class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(const std::vector<Box2>& boxes);

    /// Around all boxes; empty without items.
    Box2 box() const { return nodes_.empty() ? Box2() : nodes_.front().box; }

    /// Calls `visit(item)` for items whose box intersects `box`, in rising order; may name others near them.
    template <typename Visit>
    void forEachNear(const Box2& box, const Visit& visit) const;

    /// Calls `visit(item)` for items group by group, nearest first, while `least(box)` of their group lies
    /// below `limit()`; a visit may lower the limit. `least` is a lower bound of what a visit finds in a box.
    template <typename Least, typename Limit, typename Visit>
    void nearestFirst(const Least& least, const Limit& limit, const Visit& visit) const;

  private:
    static constexpr int kLeaf = -1;
    static constexpr std::size_t kDeepest = 64;

    struct Node {
        Box2 box;
        int right = kLeaf;  ///< the left child follows its parent
        int begin = 0;      ///< items [begin, end)
        int end = 0;
    };

    int build(const std::vector<Box2>& boxes, int begin, int end);
    const Node& node(int index) const { return nodes_[static_cast<std::size_t>(index)]; }

    std::vector<Node> nodes_;
};

template <typename Visit>
void BoxTree::forEachNear(const Box2& box, const Visit& visit) const {
    if (nodes_.empty()) return;
    std::array<int, kDeepest> pending;
    std::size_t size = 0;
    pending[size++] = 0;
    while (size > 0) {
        const int index = pending[--size];
        const Node& next = node(index);
        if (!next.box.intersects(box)) continue;
        if (next.right == kLeaf) {
            for (int i = next.begin; i < next.end; ++i)
                visit(static_cast<std::size_t>(i));
            continue;
        }
        pending[size++] = next.right;
        pending[size++] = index + 1;
    }
}

template <typename Least, typename Limit, typename Visit>
void BoxTree::nearestFirst(const Least& least, const Limit& limit, const Visit& visit) const {
    if (nodes_.empty()) return;
    struct Pending {
        int node;
        double least;
    };
    std::array<Pending, kDeepest> stack;
    std::size_t size = 0;
    stack[size++] = {0, least(nodes_.front().box)};
    while (size > 0) {
        const Pending next = stack[--size];
        if (next.least >= limit()) continue;
        const Node& at = node(next.node);
        if (at.right == kLeaf) {
            for (int i = at.begin; i < at.end; ++i)
                visit(static_cast<std::size_t>(i));
            continue;
        }
        Pending near{next.node + 1, least(node(next.node + 1).box)};
        Pending far{at.right, least(node(at.right).box)};
        if (far.least < near.least) std::swap(near, far);
        if (far.least < limit()) stack[size++] = far;
        if (near.least < limit()) stack[size++] = near;
    }
}

}  // namespace stepmill
