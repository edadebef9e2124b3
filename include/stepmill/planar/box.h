#pragma once

#include <Eigen/Geometry>

#include "stepmill/planar/vector.h"

namespace stepmill {

/// Axis-parallel box [mm]; empty until extended by the first point. Boxes that touch intersect.
using Box2 = Eigen::AlignedBox2d;

/// The box with a margin on all four sides. An empty box stays empty.
inline Box2 grown(const Box2& box, double by_mm) {
    return {box.min() - Vec2::Constant(by_mm), box.max() + Vec2::Constant(by_mm)};
}

}  // namespace stepmill
