#pragma once

#include <optional>

#include "post/hole_cycle.h"
#include "stepmill/post/post.h"

namespace stepmill {

/// Holes that are drilled: fed down in pecks.
struct DrillCycle : HoleCycle {
    double peck_mm = 0;         ///< deepest peck; 0: in one go
    bool breaks_chips = false;  ///< after each peck it stays in the hole
    bool feeds_out = false;     ///< up to the R plane
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
