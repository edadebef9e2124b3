#include "toolpath/fed_holes.h"

#include <algorithm>

#include "stepmill/core/error.h"
#include "stepmill/toolpath/path_frame.h"

namespace stepmill::toolpath {

Toolpath fedInAndOut(const std::vector<Vec2>& centres, const FedHeights& heights, const std::string& pattern,
                     double feed_mm_per_min, const Machine& machine) {
    const auto [top_z_mm, tip_z_mm, least_over_mm, retract_z_mm] = heights;
    STEPMILL_CHECK(retract_z_mm >= top_z_mm && top_z_mm > tip_z_mm, "heights of a hole are out of order");
    Toolpath path;
    path.pattern = pattern;
    path.depths = 1;
    path.step_down_mm = top_z_mm - tip_z_mm;
    path.feed_mm_per_min = path.plunge_feed_mm_per_min = feed_mm_per_min;

    const double over_top_mm = isRawTop(top_z_mm) ? machine.top_clearance_mm : 0;
    const double over_z_mm = std::min(top_z_mm + std::max(least_over_mm, over_top_mm), retract_z_mm);
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

}  // namespace stepmill::toolpath
