#pragma once

#include <optional>
#include <vector>

#include "stepmill/post/post.h"

namespace stepmill {

/// Equal holes as controllers drill them: over each rapid to the R plane, feed down in pecks, rapid out.
struct DrillCycle {
    std::vector<Vec2> places;  ///< in the order they are drilled
    double initial_z_mm = 0;   ///< where each starts and ends (G98)
    double r_z_mm = 0;
    double bottom_z_mm = 0;
    double peck_mm = 0;  ///< deepest peck; 0: in one go
    double feed_mm_per_min = 0;
};

/// Moves that are holes: how many of them lead to the first, and the cycle the rest is.
struct FoundCycle {
    std::size_t moves_before = 0;
    DrillCycle cycle;
};

/// The holes a drilling operation makes; nothing when its moves are no such thing.
std::optional<FoundCycle> findCycle(const JobOperation& operation);

}  // namespace stepmill
