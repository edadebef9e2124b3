#pragma once

#include <cmath>

namespace stepmill {

/// Heights closer than this are one, but for rounding [mm].
inline constexpr double kSameHeightMm = 1e-6;

/// The same of heights that may come out of a plan.json, which has six decimals [mm].
inline constexpr double kSameWrittenHeightMm = 1e-5;

/// Heights of bands, stairs and form cutters' tips are numbers that programs and plan.json can say [mm].
inline constexpr double kHeightStepMm = 1e-4;

/// The step nearest to a height.
inline double onHeightStep(double z_mm) {
    return std::round(z_mm / kHeightStepMm) * kHeightStepMm;
}
/// The step at a height or just over it.
inline double upOnHeightStep(double z_mm) {
    return std::ceil(z_mm / kHeightStepMm) * kHeightStepMm;
}

}  // namespace stepmill
