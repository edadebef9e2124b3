#include "plan/features/level_times.h"

#include <cmath>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/toolpath/step_over.h"

namespace stepmill {

double depthsOf(double height_mm, const CuttingData& cutting) {
    constexpr double kRounding = 1e-9;
    return cutting.step_down_mm > 0 ? std::ceil(height_mm / cutting.step_down_mm - kRounding) : 1;
}

double secondsPerMm2(const PlannedFeature& level, const ToolAssembly& tool, const CuttingData& cutting,
                     const CutterArea& area) {
    for (const SequenceStep& step : level.sequence.steps) {
        if (step.tool_id != tool.id || step.path.depths == 0 || step.area.new_area_mm2 <= 0) continue;
        return step.path.totals.motion_time_s / step.path.depths / stepmill::area(step.area.area);
    }
    const double step_over_mm = toolpath::usedStepOver(cutting, tool.radius_mm());
    const double length_mm = stepmill::area(area.free_centres) / step_over_mm + perimeter(area.free_centres);
    return length_mm / cutting.feed_mm_per_min * kSecondsPerMinute / area.coverable_area_mm2;
}

LevelTimes::LevelTimes(const PlannedFeature& level, const Tolerances& tol) : tol_(tol) {
    for (const SequenceStep& step : level.sequence.steps) {
        Region cut = intersect(step.area.area, level.feature.target, tol);
        const double all_mm2 = area(cut);
        if (all_mm2 > tol.area_mm2)
            shares_.push_back({std::move(cut), step.path.totals.motion_time_s / all_mm2});
    }
}

double LevelTimes::secondsOver(const Region& ground) const {
    if (ground.empty()) return 0;
    double seconds = 0;
    for (const Share& share : shares_)
        seconds += share.s_per_mm2 * area(intersect(share.cut, ground, tol_));
    return seconds;
}

}  // namespace stepmill
