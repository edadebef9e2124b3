#pragma once

#include <string_view>

namespace stepmill {

inline constexpr double kMillimetresPerInch = 25.4;
inline constexpr double kSecondsPerMinute = 60.0;
inline constexpr double kSecondsPerHour = 3600.0;
inline constexpr double kMm3PerCm3 = 1000.0;
inline constexpr double kPi = 3.14159265358979323846;

constexpr double inchToMm(double inch) {
    return inch * kMillimetresPerInch;
}
constexpr double mmToInch(double mm) {
    return mm / kMillimetresPerInch;
}
constexpr double degToRad(double deg) {
    return deg * kPi / 180.0;
}
constexpr double radToDeg(double rad) {
    return rad * 180.0 / kPi;
}

}  // namespace stepmill
