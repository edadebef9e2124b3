// Reaming and boring as plain moves: fed down and fed up again.

#include <algorithm>

#include "stepmill/core/error.h"
#include "stepmill/toolpath/path_frame.h"
#include "toolpath/fed_holes.h"

namespace stepmill {

Toolpath sizeHoles(const std::vector<Vec2>& centres, double top_z_mm, double tip_z_mm, double retract_z_mm,
                   const ToolAssembly& tool, const CuttingData& cutting, const Machine& machine) {
    STEPMILL_CHECK(tool.isSizer() && !centres.empty(), "only reamers and boring heads size holes");
    const double limit =
        machine.max_feed_mm_per_min > 0 ? machine.max_feed_mm_per_min : cutting.feed_mm_per_min;
    return toolpath::fedInAndOut(centres, {top_z_mm, tip_z_mm, toolpath::kOverHoleMm, retract_z_mm},
                                 tool.type == ToolType::Boring ? "bore" : "ream",
                                 std::min(cutting.feed_mm_per_min, limit), machine);
}

}  // namespace stepmill
