// Peck drilling as plain moves.

#include <algorithm>
#include <cmath>

#include "stepmill/core/error.h"
#include "stepmill/toolpath/path_frame.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill {

namespace {

/// Rapids stop this far over the hole's top [mm].
constexpr double kOverTopMm = 1.0;
/// Going back into the hole, rapids stop this far over the last peck's bottom [mm].
constexpr double kOverLastPeckMm = 0.5;
/// Pecks, where the cutting data name no step-down, in diameters.
constexpr double kPeckDiameters = 2;

}  // namespace

Toolpath drillHole(const Vec2& at, double top_z_mm, double floor_z_mm, double retract_z_mm,
                   const ToolAssembly& tool, const CuttingData& cutting, const Machine& machine) {
    STEPMILL_CHECK(tool.isDrill(), "only drills drill");
    STEPMILL_CHECK(retract_z_mm >= top_z_mm && top_z_mm > floor_z_mm, "heights of a hole are out of order");
    const double plunge_feed =
        cutting.plunge_feed_mm_per_min > 0 ? cutting.plunge_feed_mm_per_min : cutting.feed_mm_per_min;
    const double peck = cutting.step_down_mm > 0 ? cutting.step_down_mm : kPeckDiameters * tool.diameter_mm;
    const double limit = machine.max_feed_mm_per_min > 0 ? machine.max_feed_mm_per_min : plunge_feed;

    Toolpath path;
    path.pattern = "drill";
    path.start = {at.x(), at.y(), retract_z_mm};
    const double depth = top_z_mm - floor_z_mm;
    path.depths = toolpath::depthsFor(depth, peck);
    path.step_down_mm = depth / path.depths;
    path.feed_mm_per_min = std::min(cutting.feed_mm_per_min, limit);
    path.plunge_feed_mm_per_min = std::min(plunge_feed, limit);

    const double over_top_mm = toolpath::isRawTop(top_z_mm) ? machine.top_clearance_mm : 0;
    const double over_z = std::min(top_z_mm + std::max(kOverTopMm, over_top_mm), retract_z_mm);
    double at_z = retract_z_mm;
    const auto go = [&](MoveKind kind, double z) {
        if (z == at_z) return;
        path.moves.push_back({kind, {at.x(), at.y(), z}, std::nullopt, false});
        at_z = z;
    };
    double drilled_z = top_z_mm;
    for (int i = 1; i <= path.depths; ++i) {
        go(MoveKind::Rapid, i == 1 ? over_z : std::min(over_z, drilled_z + kOverLastPeckMm));
        drilled_z = i == path.depths ? floor_z_mm : top_z_mm - i * path.step_down_mm;
        go(MoveKind::Plunge, drilled_z);
        go(MoveKind::Rapid, i == path.depths ? retract_z_mm : over_z);
    }
    path.totals = measure(path, machine);
    return path;
}

}  // namespace stepmill
