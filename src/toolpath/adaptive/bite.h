#pragma once

#include <optional>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"
#include "toolpath/adaptive/front_meter.h"

namespace stepmill::toolpath {

/// Ground that one more pass clears: centres that the disc meets no material at once it has been made.
struct Bite {
    Region ground;
    std::vector<Path> fronts;  ///< its boundary where it is not that of the cleared ground
    double distance_mm = 0;    ///< from the cutter to where the nearest of them starts; infinite without any
};

/// \param at  where the cutter is
Bite biteOf(Region ground, const Region& cleared, const Vec2& at, const Tolerances& tol);

/// From `at` to where a front is gone along first: to its start or, of a closed one, to its nearest point.
double distanceToStart(const Path& front, const Vec2& at);

/// What lies in the room between the cleared ground and a way that leaves it and comes back. Nothing where
/// the way does not have that ground on its left.
std::optional<Region> groundBeside(const Path& way, const Region& cleared, const Region& room,
                                   const Tolerances& tol);

/// A stretch of a front, as lengths from its start.
struct Stretch {
    double from_mm = 0;
    double to_mm = 0;
};

/// The stretches of a front on which the rim meets material; those that lie near each other are one.
std::vector<Stretch> cuttingStretches(const FrontCut& cut, double radius_mm);

}  // namespace stepmill::toolpath
