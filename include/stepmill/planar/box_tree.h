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
    explicit BoxTree(std::vector<Box2> boxes);

    /// Around all boxes; empty without items.
    Box2 box() const { return nodes_.empty() ? Box2() : nodes_.front().box; }

    /// Calls `visit(item)` for items whose box intersects `box`, in rising order.
    template <typename Visit>
    void forEachNear(const Box2& box, const Visit& visit) const;

    /// Calls `visit(item)` for the items with `reaches(box)`, group by group; the group with the lesser
    /// `order(box)` first. A visit may shorten the reach.
    template <typename Order, typename Reaches, typename Visit>
    void nearestFirst(const Order& order, const Reaches& reaches, const Visit& visit) const;

    /// Calls `visit(item)` for items group by group, nearest first, while `least(box)` of the group's box and
    /// of the item's own lies below `limit()`; a visit may lower the limit. `least` is a lower bound of what
    /// a visit finds in a box.
    template <typename Least, typename Limit, typename Visit>
    void nearestBelow(const Least& least, const Limit& limit, const Visit& visit) const {
        nearestFirst(
            least, [&](const Box2& box) { return least(box) < limit(); }, visit);
    }

  private:
    static constexpr int kLeaf = -1;
    static constexpr int kNone = -1;
    static constexpr std::size_t kDeepest = 64;

    struct Node {
        Box2 box;
        int right = kLeaf;  ///< the left child follows its parent
        int begin = 0;      ///< items [begin, end)
        int end = 0;
    };

    int build(int begin, int end);
    const Node& node(int index) const { return nodes_[static_cast<std::size_t>(index)]; }
    const Box2& boxOf(int item) const { return boxes_[static_cast<std::size_t>(item)]; }

    std::vector<Box2> boxes_;
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
                if (boxOf(i).intersects(box)) visit(static_cast<std::size_t>(i));
            continue;
        }
        pending[size++] = next.right;
        pending[size++] = index + 1;
    }
}

template <typename Order, typename Reaches, typename Visit>
void BoxTree::nearestFirst(const Order& order, const Reaches& reaches, const Visit& visit) const {
    if (nodes_.empty() || !reaches(nodes_.front().box)) return;
    std::array<int, kDeepest> pending;
    std::size_t size = 0;
    for (int index = 0; index != kNone;) {
        const Node& at = node(index);
        int next = kNone;
        if (at.right == kLeaf) {
            for (int i = at.begin; i < at.end; ++i)
                if (reaches(boxOf(i))) visit(static_cast<std::size_t>(i));
        } else {
            int near = index + 1, far = at.right;
            const bool to_near = reaches(node(near).box), to_far = reaches(node(far).box);
            if (to_near && to_far) {
                if (order(node(far).box) < order(node(near).box)) std::swap(near, far);
                pending[size++] = far;
            }
            if (to_near)
                next = near;
            else if (to_far)
                next = far;
        }
        // The reach may have become shorter since.
        while (next == kNone && size > 0)
            if (reaches(node(pending[--size]).box)) next = pending[size];
        index = next;
    }
}

}  // namespace stepmill
