#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "stepmill/core/tolerances.h"
#include "stepmill/planar/region.h"
#include "toolpath/adaptive/front_meter.h"

namespace stepmill::toolpath {

/// What a cutter clears at one depth without ever engaging more than its limit.
struct GrowthTask {
    Region room;     ///< centres that it may go to and has to clear
    Region cleared;  ///< of these, where the disc meets no material before; not empty
    Region target;   ///< the material
    double radius_mm = 0;
    double step_over_mm = 0;
    Vec2 at = Vec2::Zero();  ///< where the cutter is, in `cleared`
    /// Passes that would be longer by what the first of them clear are not made [mm].
    double longest_mm = std::numeric_limits<double>::infinity();
};

/// A pass, climb milling, tangential where it begins and ends in cleared ground.
struct GrowthPass {
    Path path;
    /// From where the last pass has ended to this one's start, straight from point to point, over centres
    /// where the disc meets no material; nothing where no such way was found.
    std::optional<std::vector<Vec2>> way;
};

/// Passes that let the cleared ground grow until all of the room is cleared, each engaging no more than the
/// limit of the step-over: docs/algorithms/adaptive.md. Nothing where that cannot be done.
std::optional<std::vector<GrowthPass>> growthPasses(const GrowthTask& task, const Tolerances& tol);

}  // namespace stepmill::toolpath
