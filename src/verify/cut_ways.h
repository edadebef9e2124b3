#pragma once

#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "stepmill/planar/box.h"
#include "stepmill/planar/region.h"

namespace stepmill::verify {

/// The ways that a cutter's middle has gone, seen from above, each with the level it has cut down to; found
/// by place, so that of hundreds of holes of one feature each is compared with its own ways alone.
class CutWays {
  public:
    /// \param over_mm  where most of the ways will be
    /// \param cell_mm  how near ways are looked up together, above 0
    CutWays(const Box2& over_mm, double cell_mm);

    void add(double level_mm, Path way);
    /// The ways whose boxes meet `around` and that have cut down to `highest_mm` or lower, from above; of one
    /// level the ones added first come first.
    std::vector<Path> below(double highest_mm, const Box2& around) const;

  private:
    using Cell = std::pair<int, int>;

    struct Entry {
        double level_mm = 0;
        Box2 box;
        Path way;
    };

    template <typename Visit>
    void forEachCell(const Box2& box, const Visit& visit) const;
    int cellOf(double value_mm, int axis) const;

    Box2 over_mm_;
    double cell_mm_;
    std::vector<Entry> ways_;
    std::map<Cell, std::vector<std::size_t>> cells_;  ///< indices in `ways_`, rising
};

}  // namespace stepmill::verify
