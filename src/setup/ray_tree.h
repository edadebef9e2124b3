#pragma once

#include <vector>

#include "setup/facets.h"

namespace stepmill::setup {

/// Facets in a tree of boxes, to ask what a ray meets. Immutable after construction; safe to read from
/// several threads. O(n log n) to build, about O(log n) a ray.
class RayTree {
  public:
    explicit RayTree(Facets facets);

    /// Does the ray meet any facet? Facets met at the start itself do not count.
    bool blocked(const Vec3& from, const Vec3& direction) const;
    /// Distance to the first facet along the ray; infinity when it meets none.
    double distance(const Vec3& from, const Vec3& direction) const;

  private:
    struct Node {
        Box3 box;
        int first = 0;  ///< facets of a leaf; children of an inner node stand at `first` and `first + 1`
        int count = 0;  ///< 0: inner node
    };
    void split(int node, int first, int count);
    template <typename Hit>
    void walk(const Vec3& from, const Vec3& direction, Hit&& hit) const;

    Facets facets_;
    std::vector<Node> nodes_;
};

}  // namespace stepmill::setup
