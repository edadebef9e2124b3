#pragma once

#include <cstddef>
#include <span>

namespace stepmill::layers {

/// Takes, in order, the corners of a closed polygon's part where `inside(corner)` is not negative, which is
/// linear over it [Sutherland1974]. The part is one polygon: where it leaves and comes back it runs along the
/// edge, and may run there twice, which windings do not mind.
/// \param between  the point at a share of the way from one corner to the next
template <typename Corner, typename Inside, typename Between, typename Take>
void clipPolygon(std::span<const Corner> corners, const Inside& inside, const Between& between,
                 const Take& take) {
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Corner& a = corners[i];
        const Corner& b = corners[(i + 1) % corners.size()];
        const double at_a = inside(a);
        const double at_b = inside(b);
        if (at_a >= 0) take(a);
        if ((at_a > 0 && at_b < 0) || (at_a < 0 && at_b > 0)) take(between(a, b, at_a / (at_a - at_b)));
    }
}

}  // namespace stepmill::layers
