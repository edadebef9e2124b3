#include "report/page/measures.h"

#include <fmt/format.h>

#include "report/page/words.h"
#include "stepmill/core/units.h"

namespace stepmill::report {
namespace {

constexpr double kInchesAFoot = 12;
constexpr double kMmAMetre = 1000;
constexpr double kFineSteps = 1000;
constexpr double kMm2ASquareInch = kMillimetresPerInch * kMillimetresPerInch;
constexpr double kMm3ACubicInch = kMillimetresPerInch * kMm2ASquareInch;
constexpr double kMm3ACm3 = 1000;

}  // namespace

std::string Measures::number(double length_mm, int decimals) const {
    const std::string text = inch_ ? fixed(mmToInch(length_mm), decimals + 1) : fixed(length_mm, decimals);
    // "-0.00" is nothing but rounding.
    return text.find_first_not_of("-0.") == std::string::npos && text.front() == '-' ? text.substr(1) : text;
}

std::string Measures::length(double length_mm, int decimals) const {
    return fmt::format("{} {}", number(length_mm, decimals), unit());
}

std::string Measures::size(const Vec3& size_mm) const {
    return fmt::format("{} × {} × {} {}", number(size_mm.x()), number(size_mm.y()), number(size_mm.z()),
                       unit());
}

std::string Measures::place(const Vec3& at_mm) const {
    return fmt::format("X {} Y {} Z {} {}", number(at_mm.x()), number(at_mm.y()), number(at_mm.z()), unit());
}

std::string Measures::feed(double feed_mm_per_min) const {
    return inch_ ? fixed(mmToInch(feed_mm_per_min), 1) : fixed(feed_mm_per_min, 0);
}

std::string Measures::way(double length_mm) const {
    return inch_ ? fixed(mmToInch(length_mm) / kInchesAFoot, 1) + " ft" : fixed(length_mm / 1000, 1) + " m";
}

std::string Measures::wayNumber(double length_mm, int decimals) const {
    return inch_ ? fixed(mmToInch(length_mm) / kInchesAFoot, decimals - 1)
                 : fixed(length_mm / kMmAMetre, decimals);
}

std::string Measures::fine(double length_mm) const {
    return fixed(kFineSteps * (inch_ ? mmToInch(length_mm) : length_mm), 2);
}

std::string Measures::area(double area_mm2, int decimals) const {
    return inch_ ? fixed(area_mm2 / kMm2ASquareInch, decimals + 2) : fixed(area_mm2, decimals);
}

std::string Measures::volume(double volume_mm3, int decimals) const {
    return inch_ ? fixed(volume_mm3 / kMm3ACubicInch, decimals + 1) : fixed(volume_mm3 / kMm3ACm3, decimals);
}

double Measures::lengthOf(double length_mm) const {
    return inch_ ? mmToInch(length_mm) : length_mm;
}

double Measures::volumeOf(double volume_mm3) const {
    return volume_mm3 / (inch_ ? kMm3ACubicInch : kMm3ACm3);
}

std::string Measures::crumb(double volume_mm3) const {
    return inch_ ? fixed(volume_mm3 / kMm3ACubicInch, 5) + " in³" : fixed(volume_mm3, 2) + " mm³";
}

}  // namespace stepmill::report
