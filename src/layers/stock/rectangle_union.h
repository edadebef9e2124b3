#pragma once

#include <vector>

#include "stepmill/planar/box.h"
#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// Many rectangles along x and y as the ground they cover together.
///
/// A sweep over columns between neighbouring sides; no boolean is computed. O(n log n) for n rectangles and
/// for every column the rectangles that cross it.
class RectangleUnion {
  public:
    /// \param same_mm  sides nearer than this are one
    RectangleUnion(const std::vector<Box2>& boxes, double same_mm);

    /// The same ground as boxes that share sides at most.
    std::vector<Box2> apart() const;
    /// The same ground as a region; corners that touch are two loops.
    Region outline() const;

  private:
    struct Stretch {
        double low = 0;
        double high = 0;

        bool operator==(const Stretch&) const = default;
    };

    std::vector<double> sides_;  ///< of the columns, ascending: column i lies left of side i + 1
    std::vector<std::vector<Stretch>> covered_;  ///< by column, ascending, none touching the next
};

}  // namespace stepmill::layers
