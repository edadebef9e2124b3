#pragma once

#include <optional>

#include "stepmill/catalog/tool.h"

namespace stepmill {

enum class Plane { XY, ZX, YZ };                                ///< G17, G18, G19
enum class DistanceMode { Absolute, Incremental };              ///< G90, G91
enum class FeedMode { InverseTime, PerMinute, PerRevolution };  ///< G93, G94, G95
enum class PathControl { ExactPath, ExactStop, Blend };         ///< G61, G61.1, G64
enum class Spin { Off, Clockwise, CounterClockwise };           ///< M5, M3, M4

/// H of a length offset that is off (G49).
inline constexpr int kNoLengthOffset = 0;
/// The work offset plans are made for: the first of nine, G54 to G59.3.
inline constexpr int kPlannedWorkOffset = 1;

/// What a controller is set to while something runs. Empty: the program has not said it, so that what an
/// earlier program left holds.
struct MachineState {
    std::optional<Plane> plane;
    std::optional<DistanceMode> distance;
    std::optional<FeedMode> feed_mode;
    bool compensation_off = false;     ///< G40 was said; G41 and G42 are not read
    std::optional<int> length_offset;  ///< H in force, or kNoLengthOffset
    std::optional<int> work_offset;    ///< 1 to 9: G54 to G59.3
    std::optional<PathControl> path_control;
    double blend_mm = 0;  ///< P of G64: how far corners may be cut; 0: as far as it likes
    Spin spin = Spin::Off;
    double speed_rpm = 0;
    bool mist = false;
    bool flood = false;
    std::optional<int> tool;  ///< in the spindle; none until one was put in

    bool operator==(const MachineState&) const = default;
};

}  // namespace stepmill
