// Reaming and boring as plain moves: fed down and fed up again.

#include <algorithm>

#include "stepmill/core/error.h"
#include "stepmill/toolpath/path_frame.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill {
Toolpath sizeHoles(const std::vector<Vec2>& centres, double top_z_mm, double tip_z_mm, double retract_z_mm,
                   const ToolAssembly& tool, const CuttingData& cutting, const Machine& machine) {
    STEPMILL_CHECK(tool.isSizer() && !centres.empty(), "only reamers and boring heads size holes");
    STEPMILL_CHECK(retract_z_mm >= top_z_mm && top_z_mm > tip_z_mm, "heights of a hole are out of order");
    const double limit =
        machine.max_feed_mm_per_min > 0 ? machine.max_feed_mm_per_min : cutting.feed_mm_per_min;
    Toolpath path;
    path.pattern = tool.type == ToolType::Boring ? "bore" : "ream";
    path.depths = 1;
    path.step_down_mm = top_z_mm - tip_z_mm;
    path.feed_mm_per_min = path.plunge_feed_mm_per_min = std::min(cutting.feed_mm_per_min, limit);

    const double over_top_mm = toolpath::isRawTop(top_z_mm) ? machine.top_clearance_mm : 0;
    const double over_z_mm = std::min(top_z_mm + std::max(toolpath::kOverHoleMm, over_top_mm), retract_z_mm);
    const auto move = [&](MoveKind kind, const Vec2& at, double z_mm) {
        path.moves.push_back({kind, {at.x(), at.y(), z_mm}, std::nullopt, false});
    };
    path.start = {centres.front().x(), centres.front().y(), retract_z_mm};
    for (const Vec2& centre : centres) {
        if (!path.moves.empty()) move(MoveKind::Rapid, centre, retract_z_mm);
        if (over_z_mm < retract_z_mm) move(MoveKind::Rapid, centre, over_z_mm);
        move(MoveKind::Plunge, centre, tip_z_mm);
        move(MoveKind::Feed, centre, over_z_mm);
        if (over_z_mm < retract_z_mm) move(MoveKind::Rapid, centre, retract_z_mm);
    }
    path.totals = measure(path, machine);
    return path;
}

}  // namespace stepmill
