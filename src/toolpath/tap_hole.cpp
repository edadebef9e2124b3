// Rigid tapping as plain moves: down and up again with the spindle's turns.

#include <algorithm>

#include "stepmill/core/error.h"
#include "toolpath/fed_holes.h"

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
    const double run_up_mm = std::max(kLeastRunUpMm, kRunUpPitches * tool.thread->pitch_mm);
    return toolpath::fedInAndOut(centres, {top_z_mm, tip_z_mm, run_up_mm, retract_z_mm}, "tap",
                                 tool.thread->pitch_mm * speed_rpm, machine);
}

}  // namespace stepmill
