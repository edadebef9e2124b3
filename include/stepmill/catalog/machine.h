#pragma once

#include <array>
#include <string>

namespace stepmill {

struct Machine {
    std::string name;
    double rapid_mm_per_min = 0;
    double max_feed_mm_per_min = 0;
    double max_speed_rpm = 0;
    double tool_change_s = 0;
    double hourly_rate = 0;
    std::string currency;
    std::array<double, 3> travel_mm{};
    int magazine_size = 0;
    double acceleration_mm_per_s2 = 0;  ///< of the axes; 0: not given, times are those of the feeds alone
    /// How far the axes may cut a corner short to go round it without a stop; also without acceleration
    /// given.
    double junction_deviation_mm = 0.01;
    double safe_height_mm = 0;  ///< retract this far over the stock's top between features
    std::string dialect;        ///< post processor: "linuxcnc", "fanuc", "grbl"
};

}  // namespace stepmill
