#pragma once

#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// Twice the area that two vectors of the plane span, positive where b lies left of a.
inline double cross(const Vec2& a, const Vec2& b) {
    return a.x() * b.y() - a.y() * b.x();
}

}  // namespace stepmill::layers
