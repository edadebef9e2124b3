#pragma once

#include <optional>

#include "post/hole_cycle.h"
#include "stepmill/post/post.h"

namespace stepmill {

/// Holes that are tapped: down and up again with the spindle's turns.
struct TapCycle : HoleCycle {
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
