// Rigid tapping as plain moves: down and up again with the spindle's turns.

#include <algorithm>

#include "stepmill/core/error.h"
#include "stepmill/toolpath/path_frame.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill {
namespace {

/// The spindle comes up to speed, and turns round again, over the hole: so many pitches, and at least as far
/// as a drill's rapids stay off [mm].
constexpr double kRunUpPitches = 3;
constexpr double kLeastRunUpMm = 1.0;

}  // namespace

Toolpath tapHoles(const std::vector<Vec2>& centres, double top_z_mm, double tip_z_mm, double retract_z_mm,
                  const ToolAssembly& tool, double speed_rpm, const Machine& machine) {
    STEPMILL_CHECK(tool.isTap() && tool.thread && !centres.empty(), "only taps tap, and they tap holes");
    STEPMILL_CHECK(retract_z_mm >= top_z_mm && top_z_mm > tip_z_mm, "heights of a hole are out of order");
    Toolpath path;
    path.pattern = "tap";
    path.depths = 1;
    path.step_down_mm = top_z_mm - tip_z_mm;
    path.feed_mm_per_min = path.plunge_feed_mm_per_min = tool.thread->pitch_mm * speed_rpm;

    const double over_top_mm = toolpath::isRawTop(top_z_mm) ? machine.top_clearance_mm : 0;
    const double run_up_mm = std::max({kLeastRunUpMm, kRunUpPitches * tool.thread->pitch_mm, over_top_mm});
    const double over_z_mm = std::min(top_z_mm + run_up_mm, retract_z_mm);
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
