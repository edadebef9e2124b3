#pragma once

#include <optional>
#include <vector>

namespace stepmill {

/// A vise of the shop: sizes, what lies in it, and how it may be used [mm]. The defaults are an ordinary vise
/// of machining centres with jaws 150 mm wide.
struct Vise {
    double opening_mm = 220;       ///< jaws open no wider
    double jaw_width_mm = 150;     ///< along what they hold
    double jaw_height_mm = 40;     ///< of the jaws over the bed, on which parallels stand
    double jaw_thickness_mm = 40;  ///< across
    /// Heights of the pairs of parallels there are, ascending. Without any the stock lies on the bed.
    std::vector<double> parallels_mm = {6, 8, 10, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30, 32, 34, 35};
    double grip_mm = 5;           ///< the jaws hold at least that much height of the stock
    double jaw_clearance_mm = 2;  ///< cutting stays so far above the jaws

    /// The least height of a stock on the bed or on parallels that the jaws hold, no less than the grip;
    /// nothing where they are lower than that [mm].
    std::optional<double> leastHoldMm() const {
        std::optional<double> least_mm;
        const auto consider = [&](double hold_mm) {
            if (hold_mm >= grip_mm && (!least_mm || hold_mm < *least_mm)) least_mm = hold_mm;
        };
        consider(jaw_height_mm);
        for (const double height_mm : parallels_mm)
            consider(jaw_height_mm - height_mm);
        return least_mm;
    }

    bool operator==(const Vise&) const = default;
};

}  // namespace stepmill
