#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace stepmill {

/// A tolerance class of holes [ISO 286-1]: a letter for where the zone lies, a grade for how wide it is.
struct Fit {
    std::string name;    ///< "H7"
    std::string letter;  ///< "F", "G", "H", "JS"
    int grade = 0;       ///< 6 to 11
};

/// The fit of a name; nothing for other letters and grades.
std::optional<Fit> fitFrom(std::string_view name);

/// Which diameters a bore may have.
struct BoreLimits {
    double least_mm = 0;
    double most_mm = 0;
};

/// The limits of a bore of that nominal diameter. Nothing over 250 mm, where no table is kept.
std::optional<BoreLimits> boreLimits(const Fit& fit, double nominal_mm);

}  // namespace stepmill
