#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <vector>

#include "stepmill/planar/edge.h"

namespace stepmill::toolpath {

/// A line or arc, whichever way it is gone, by what programs have of it: its ends and centre to the last
/// decimal. A centre that a program tells from the arc's start differs by less, as it is gone one way or the
/// other.
using EdgeKey = std::array<std::int64_t, 7>;
/// A key, and whether the edge is gone from its second end to its first.
struct DirectedKey {
    EdgeKey key{};
    bool turned = false;
};
DirectedKey keyOf(const Edge& edge);

/// A way that a disc has gone.
struct SweptWay {
    Edge edge;
    double radius_mm = 0;
    double low_z_mm = 0;  ///< it has swept down to here
    Box2 box;             ///< with the disc
};

/// Ways in the order they were gone, in blocks with a box each: ways that follow each other lie together.
class SweptWays {
  public:
    /// Adds a way; one that was gone before in the same width is deepened.
    void add(const Edge& edge, double radius_mm, double low_z_mm);

    bool empty() const { return ways_.empty(); }

    /// Calls `visit(way)` for the ways whose discs may reach into the box and that go down to `z_mm`.
    template <typename Visit>
    void forEachNear(const Box2& box, double z_mm, const Visit& visit) const {
        for (std::size_t block = 0; block < blocks_.size(); ++block) {
            if (!blocks_[block].intersects(box)) continue;
            const std::size_t end = std::min(ways_.size(), (block + 1) * kBlock);
            for (std::size_t i = block * kBlock; i < end; ++i)
                if (ways_[i].low_z_mm <= z_mm && ways_[i].box.intersects(box)) visit(ways_[i]);
        }
    }

    /// A number for the set of ways that go down to a height: equal for equal sets, and for others as rarely
    /// as two random numbers of 64 bits are.
    std::uint64_t setOf(double z_mm) const;

  private:
    static constexpr std::size_t kBlock = 16;

    std::vector<SweptWay> ways_;
    std::vector<Box2> blocks_;  ///< of kBlock ways each
    std::map<std::pair<EdgeKey, double>, std::size_t> known_;
    mutable std::map<double, std::uint64_t> sets_;  ///< asked for since the last change
};

}  // namespace stepmill::toolpath
