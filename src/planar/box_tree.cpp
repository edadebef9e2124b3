#include "stepmill/planar/box_tree.h"

namespace stepmill {

namespace {

constexpr int kLeafItems = 4;

}  // namespace

BoxTree::BoxTree(std::vector<Box2> boxes) : boxes_(std::move(boxes)) {
    if (boxes_.empty()) return;
    nodes_.reserve(boxes_.size());
    build(0, static_cast<int>(boxes_.size()));
}

/// Adds the tree over items [begin, end) and returns its node.
int BoxTree::build(int begin, int end) {
    const auto index = nodes_.size();
    nodes_.push_back({Box2(), kLeaf, begin, end});
    Box2 box;
    if (end - begin <= kLeafItems) {
        for (int i = begin; i < end; ++i)
            box.extend(boxOf(i));
    } else {
        const int middle = begin + (end - begin) / 2;
        const int left = build(begin, middle);
        const int right = build(middle, end);
        box = node(left).box.merged(node(right).box);
        nodes_[index].right = right;
    }
    nodes_[index].box = box;
    return static_cast<int>(index);
}

}  // namespace stepmill
