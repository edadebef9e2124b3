#include "report/page/measures.h"

#include <fmt/format.h>

#include "report/page/words.h"
#include "stepmill/core/units.h"

namespace stepmill::report {
namespace {

constexpr double kInchesAFoot = 12;

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

}  // namespace stepmill::report
