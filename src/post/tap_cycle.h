#pragma once

#include <optional>
#include <vector>

#include "stepmill/post/post.h"

namespace stepmill {

/// Holes as controllers tap them: over each, rapid to the R plane, down and up again with the spindle's
/// turns, rapid out.
struct TapCycle {
    std::vector<Vec2> places;  ///< in the order they are tapped
    double initial_z_mm = 0;   ///< where each starts and ends
    double r_z_mm = 0;
    double bottom_z_mm = 0;
    double pitch_mm = 0;
    double speed_rpm = 0;
};

/// Moves that tap: how many of them lead to the first hole, and the cycle the rest is.
struct FoundTapCycle {
    std::size_t moves_before = 0;
    TapCycle cycle;
};

/// The holes a tapping operation taps; nothing when its moves are no such thing.
std::optional<FoundTapCycle> findTapCycle(const JobOperation& operation);

}  // namespace stepmill
