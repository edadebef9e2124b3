// Drilling as plain moves.

#include <algorithm>
#include <cmath>

#include "stepmill/core/error.h"
#include "stepmill/toolpath/path_frame.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill {

namespace {

/// Going back into the hole, rapids stop this far over the last peck's bottom [mm].
constexpr double kOverLastPeckMm = 0.5;
/// Pecks, where the cutting data name no step-down, in diameters.
constexpr double kPeckDiameters = 2;

int pecksFor(double depth_mm, const ToolAssembly& tool, const CuttingData& cutting) {
    if (depth_mm <= kOneGoDiameters * tool.diameter_mm) return 1;
    const double peck_mm =
        cutting.step_down_mm > 0 ? cutting.step_down_mm : kPeckDiameters * tool.diameter_mm;
    return toolpath::depthsFor(depth_mm, peck_mm);
}

/// Heights of a hole.
struct HoleHeights {
    double top_z_mm = 0;
    double tip_z_mm = 0;
    double over_z_mm = 0;  ///< rapids come down to here
    double retract_z_mm = 0;
};

/// Writes hole after hole.
class HoleWriter {
  public:
    HoleWriter(const HoleHeights& heights, Toolpath& path) : heights_(heights), path_(path) {}

    void drill(const Vec2& at) {
        if (at != at_) move(MoveKind::Rapid, at, heights_.retract_z_mm);
        double drilled_z = heights_.top_z_mm;
        for (int i = 1; i <= path_.depths; ++i) {
            const bool last = i == path_.depths;
            if (i == 1 || !breaksChips())
                goTo(MoveKind::Rapid,
                     i == 1 ? heights_.over_z_mm : std::min(heights_.over_z_mm, drilled_z + kOverLastPeckMm));
            drilled_z = last ? heights_.tip_z_mm : heights_.top_z_mm - i * path_.step_down_mm;
            goTo(MoveKind::Plunge, drilled_z);
            goTo(MoveKind::Rapid, last            ? heights_.retract_z_mm
                                  : breaksChips() ? drilled_z + kChipBreakLiftMm
                                                  : heights_.over_z_mm);
        }
    }

    void startAt(const Vec2& at) {
        at_ = at;
        z_mm_ = heights_.retract_z_mm;
        path_.start = {at.x(), at.y(), z_mm_};
    }

  private:
    bool breaksChips() const { return path_.pattern == kChipBreakPattern; }
    void goTo(MoveKind kind, double z_mm) {
        if (z_mm != z_mm_) move(kind, at_, z_mm);
    }
    void move(MoveKind kind, const Vec2& to, double z_mm) {
        path_.moves.push_back({kind, {to.x(), to.y(), z_mm}, std::nullopt, false});
        at_ = to;
        z_mm_ = z_mm;
    }

    const HoleHeights& heights_;
    Toolpath& path_;
    Vec2 at_ = Vec2::Zero();
    double z_mm_ = 0;
};

}  // namespace

Toolpath drillHoles(const std::vector<Vec2>& centres, double top_z_mm, double tip_z_mm, double retract_z_mm,
                    const ToolAssembly& tool, const CuttingData& cutting, const Machine& machine) {
    STEPMILL_CHECK((tool.isDrill() || tool.isSpot()) && !centres.empty(),
                   "only drills drill, and they drill holes");
    STEPMILL_CHECK(retract_z_mm >= top_z_mm && top_z_mm > tip_z_mm, "heights of a hole are out of order");
    const double plunge_feed =
        cutting.plunge_feed_mm_per_min > 0 ? cutting.plunge_feed_mm_per_min : cutting.feed_mm_per_min;
    const double limit = machine.max_feed_mm_per_min > 0 ? machine.max_feed_mm_per_min : plunge_feed;

    Toolpath path;
    path.pattern = "drill";
    const double depth = top_z_mm - tip_z_mm;
    path.depths = pecksFor(depth, tool, cutting);
    path.step_down_mm = depth / path.depths;
    if (path.depths > 1 && depth <= kChipBreakDiameters * tool.diameter_mm) path.pattern = kChipBreakPattern;
    path.feed_mm_per_min = std::min(cutting.feed_mm_per_min, limit);
    path.plunge_feed_mm_per_min = std::min(plunge_feed, limit);

    const double over_top_mm = toolpath::isRawTop(top_z_mm) ? machine.top_clearance_mm : 0;
    const double over_z = std::min(top_z_mm + std::max(toolpath::kOverHoleMm, over_top_mm), retract_z_mm);
    const HoleHeights heights{top_z_mm, tip_z_mm, over_z, retract_z_mm};
    HoleWriter writer(heights, path);
    writer.startAt(centres.front());
    for (const Vec2& centre : centres)
        writer.drill(centre);
    path.totals = measure(path, machine);
    return path;
}

Toolpath drillHole(const Vec2& at, double top_z_mm, double tip_z_mm, double retract_z_mm,
                   const ToolAssembly& tool, const CuttingData& cutting, const Machine& machine) {
    return drillHoles({at}, top_z_mm, tip_z_mm, retract_z_mm, tool, cutting, machine);
}

}  // namespace stepmill
