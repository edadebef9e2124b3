#pragma once

#include <cmath>
#include <vector>

#include "stepmill/part/part.h"
#include "stepmill/planar/vector.h"

namespace stepmill {

/// Positions closer than this are one: what the decimals of a program leave of equality [mm].
inline constexpr double kSamePlaceMm = 1e-3;

inline bool above(const Vec3& a, const Vec3& b) {
    return (a.head<2>() - b.head<2>()).norm() <= kSamePlaceMm;
}

inline bool sameHeight(double a_mm, double b_mm) {
    return std::abs(a_mm - b_mm) <= kSamePlaceMm;
}

/// Equal holes as controllers make them: over each rapid to the R plane, down to the bottom, rapid out.
struct HoleCycle {
    std::vector<Vec2> places;  ///< in their order
    double initial_z_mm = 0;   ///< where each starts and ends (G98)
    double r_z_mm = 0;
    double bottom_z_mm = 0;

    bool hasHeightsOf(const HoleCycle& other) const {
        return sameHeight(initial_z_mm, other.initial_z_mm) && sameHeight(r_z_mm, other.r_z_mm) &&
               sameHeight(bottom_z_mm, other.bottom_z_mm);
    }
};

}  // namespace stepmill
