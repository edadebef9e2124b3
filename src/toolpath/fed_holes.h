#pragma once

#include <string>
#include <vector>

#include "stepmill/toolpath/toolpath.h"

namespace stepmill::toolpath {

/// Heights of holes that a tool goes into by feed alone.
struct FedHeights {
    double top_z_mm = 0;
    double tip_z_mm = 0;  ///< how deep the tip goes
    double over_mm = 0;   ///< rapids stay so far over the top, farther where that is raw
    double retract_z_mm = 0;
};

/// Hole after hole, fed down and fed up again: no rapid in a hole. Costs O(holes).
Toolpath fedInAndOut(const std::vector<Vec2>& centres, const FedHeights& heights, const std::string& pattern,
                     double feed_mm_per_min, const Machine& machine);

}  // namespace stepmill::toolpath
