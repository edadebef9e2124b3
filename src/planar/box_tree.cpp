#include "stepmill/planar/box_tree.h"

namespace stepmill {

namespace {

constexpr int kLeafItems = 4;

}  // namespace

BoxTree::BoxTree(const std::vector<Box2>& boxes) {
    if (!boxes.empty()) build(boxes, 0, static_cast<int>(boxes.size()));
}

/// Adds the tree over items [begin, end) and returns its node.
int BoxTree::build(const std::vector<Box2>& boxes, int begin, int end) {
    const auto index = nodes_.size();
    nodes_.push_back({Box2(), kLeaf, begin, end});
    Box2 box;
    if (end - begin <= kLeafItems) {
        for (int i = begin; i < end; ++i)
            box.extend(boxes[static_cast<std::size_t>(i)]);
    } else {
        const int middle = begin + (end - begin) / 2;
        const int left = build(boxes, begin, middle);
        const int right = build(boxes, middle, end);
        box = node(left).box.merged(node(right).box);
        nodes_[index].right = right;
    }
    nodes_[index].box = box;
    return static_cast<int>(index);
}

}  // namespace stepmill
