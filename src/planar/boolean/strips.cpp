#include "planar/boolean/strips.h"

#include <algorithm>

#include "planar/boolean/grouped.h"
#include "stepmill/planar/vector.h"

namespace stepmill::planar {

Strips::Strips(std::span<const Box2> boxes, int axis, std::size_t count, std::span<const int> order)
    : first_(count + 1, 0) {
    Box2 all;
    for (const Box2& box : boxes)
        all.extend(box);
    low_mm_ = all.min()[axis];
    per_mm_ = static_cast<double>(count) / std::max(all.sizes()[axis], kGridMm);
    std::vector<int> strips;  // of each entry of a box into one
    std::vector<int> entered;
    for (const int i : order) {
        const Box2& box = boxes[static_cast<std::size_t>(i)];
        for (std::size_t strip = of(box.min()[axis]); strip <= of(box.max()[axis]); ++strip) {
            strips.push_back(static_cast<int>(strip));
            entered.push_back(i);
        }
    }
    const Grouped by_strip(strips, count);
    boxes_.reserve(entered.size());
    for (std::size_t strip = 0; strip < count; ++strip) {
        for (const int entry : by_strip[strip])
            boxes_.push_back(entered[static_cast<std::size_t>(entry)]);
        first_[strip + 1] = boxes_.size();
    }
}

std::size_t Strips::of(double value_mm) const {
    const double strip = (value_mm - low_mm_) * per_mm_;
    return std::min(count() - 1, static_cast<std::size_t>(std::max(0.0, strip)));
}

}  // namespace stepmill::planar
