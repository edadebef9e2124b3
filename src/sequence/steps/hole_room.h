#pragma once

#include "stepmill/feature/feature.h"

namespace stepmill {

/// Does a cylinder around the hole's axis meet what stands over its bottom?
bool meetsObstacle(const Feature& hole, const Vec2& axis, double bottom_z_mm, double radius_mm);

}  // namespace stepmill
