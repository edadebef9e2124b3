#pragma once

#include "stepmill/planar/region.h"

namespace stepmill {

/// An arc that leaves `from` in a direction and ends at `to`; straight where it hardly bends: centres farther
/// off than 90 m are more than controllers take.
/// \pre `along` has length 1
Segment arcTo(const Vec2& from, const Vec2& along, const Vec2& to);

}  // namespace stepmill
