#pragma once

#include <array>
#include <string>

namespace stepmill {

/// What a milling machine can do and what its hour costs. Zero means "not given"; the comments say what then
/// holds.
struct Machine {
    std::string name;
    double rapid_mm_per_min = 0;
    double max_feed_mm_per_min = 0;  ///< 0: no limit
    double max_speed_rpm = 0;        ///< 0: no limit
    double tool_change_s = 0;        ///< chip to chip
    double hourly_rate = 0;          ///< 0: machine time is free
    std::string currency;
    std::array<double, 3> travel_mm{};  ///< along x, y, z; 0: not checked
    int magazine_size = 0;              ///< places for tools; 0: no limit
    double acceleration_mm_per_s2 = 0;  ///< of the axes; 0: not given, times are those of the feeds alone
    /// How far the axes may cut a corner short to go round it without a stop; also without acceleration
    /// given.
    double junction_deviation_mm = 0.01;
    double safe_height_mm = 0;  ///< retract this far over the stock's top between features
    std::string dialect;        ///< post processor: "linuxcnc", "fanuc", "grbl"
};

}  // namespace stepmill
