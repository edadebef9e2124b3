#pragma once

#include <string>

#include <fmt/format.h>

#include "stepmill/planar/vector.h"

namespace stepmill::verify {

/// A tip this near to a hole's axis is in that hole [mm].
inline constexpr double kOnAxisMm = 0.01;

inline bool isOver(const Vec3& place, const Vec2& axis) {
    return (Vec2(place.head<2>()) - axis).norm() <= kOnAxisMm;
}

inline std::string placeWords(const Vec2& axis) {
    return fmt::format("at X{:.3f} Y{:.3f}", axis.x(), axis.y());
}

}  // namespace stepmill::verify
