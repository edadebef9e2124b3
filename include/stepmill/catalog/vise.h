#pragma once

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

    bool operator==(const Vise&) const = default;
};

}  // namespace stepmill
