#pragma once

#include "stepmill/planar/region.h"

namespace stepmill::access {

/// How far from what stands some of a place lies: bounds, found from distances alone.
struct FarthestRoom {
    double reached_mm = 0;  ///< so far off lies a disc within the place; 0 where none was found
    double most_mm = 0;     ///< no point of the place lies farther off
};

/// Halves squares over the place, those that may lie farthest off first, until both bounds are within a
/// twentieth of a millimetre or the number of squares is what an offset costs.
///
/// \param disc_mm  radius of the disc that `reached_mm` speaks of
/// \return  {0, 0} for an empty place.
/// \pre `standing` is not empty
FarthestRoom farthestRoom(const Region& place, const Region& standing, double disc_mm);

}  // namespace stepmill::access
