#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "stepmill/planar/box.h"

namespace stepmill::planar {

/// Boxes sorted by the strips of x or y that they reach into, so that who asks at one height meets few of
/// them in vain. A long box is in many strips.
class Strips {
  public:
    Strips() = default;
    /// \param axis   0: strips of x; 1: of y
    /// \param count  how many strips, at least 1
    /// \param order  of the boxes, by their numbers, kept within each strip
    Strips(std::span<const Box2> boxes, int axis, std::size_t count, std::span<const int> order);

    std::size_t count() const { return first_.size() - 1; }
    /// The strip of a value along the axis; the nearest one of values beyond all.
    std::size_t of(double value_mm) const;
    /// Numbers of the boxes in the strip.
    std::span<const int> operator[](std::size_t strip) const {
        return {boxes_.data() + first_[strip], boxes_.data() + first_[strip + 1]};
    }

  private:
    double low_mm_ = 0;
    double per_mm_ = 0;
    std::vector<int> boxes_;                // strip by strip
    std::vector<std::size_t> first_ = {0};  // of each strip, its first; then one past all
};

}  // namespace stepmill::planar
