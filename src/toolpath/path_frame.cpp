#include "stepmill/toolpath/path_frame.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill::toolpath {
namespace {

/// Where the cutting data name no ramp angle.
constexpr double kDefaultRampAngleDeg = 3;
/// A depth that exceeds whole steps by no more than this share of a step takes no further one.
constexpr double kDepthExcess = 1e-9;
/// A top no lower than this under the stock's own is that: heights in plan.json are rounded [mm].
constexpr double kSameTopMm = 1e-4;

}  // namespace

double rampAngleDeg(const CuttingData& cutting) {
    return cutting.ramp_angle_deg > 0 ? cutting.ramp_angle_deg : kDefaultRampAngleDeg;
}

double rampAngle(const CuttingData& cutting) {
    return degToRad(rampAngleDeg(cutting));
}

double usedStepOver(const CuttingData& cutting, double radius_mm) {
    return cutting.step_over_mm > 0 ? std::min(cutting.step_over_mm, radius_mm) : radius_mm;
}

int depthsFor(double depth_mm, double step_down_mm) {
    if (step_down_mm <= 0) return 1;
    const double depths = std::ceil(depth_mm / step_down_mm - kDepthExcess);
    if (!(depths <= kMostDepths))
        throw Error(ErrorCode::InvalidCatalog, fmt::format("step-down {:g} mm", step_down_mm),
                    fmt::format("would take more than {} cuts for {:g} mm", kMostDepths, depth_mm));
    return std::max(1, static_cast<int>(depths));
}

Toolpath pathFrame(const ClearingTask& task, int depths, double radius_mm, const CuttingData& cutting,
                   const Machine& machine) {
    Toolpath path;
    path.step_over_mm = usedStepOver(cutting, radius_mm);
    path.depths = depths;
    path.step_down_mm = (task.top_z_mm - task.floor_z_mm) / path.depths;
    const double limit = machine.max_feed_mm_per_min;
    const auto limited = [&](double feed) { return limit > 0 ? std::min(feed, limit) : feed; };
    path.feed_mm_per_min = limited(cutting.feed_mm_per_min);
    // No mill goes down faster than it cuts.
    path.plunge_feed_mm_per_min = path.feed_mm_per_min;
    if (cutting.plunge_feed_mm_per_min > 0)
        path.plunge_feed_mm_per_min = std::min(path.feed_mm_per_min, cutting.plunge_feed_mm_per_min);
    path.ramp_feed_mm_per_min =
        rampFeed(path.feed_mm_per_min, path.plunge_feed_mm_per_min, rampAngle(cutting));
    // A slot feed that is none slower needs no telling apart; ramps cut full width too.
    if (cutting.slot_feed_mm_per_min > 0 && cutting.slot_feed_mm_per_min < path.feed_mm_per_min) {
        path.slot_feed_mm_per_min = cutting.slot_feed_mm_per_min;
        path.ramp_feed_mm_per_min = std::min(path.ramp_feed_mm_per_min, path.slot_feed_mm_per_min);
    }
    return path;
}

double helixWidth(double circle_radius_mm, double radius_mm) {
    const double narrow_mm = std::min(circle_radius_mm, radius_mm);
    const double out_mm = narrow_mm + radius_mm;
    return out_mm * out_mm / (2 * narrow_mm);
}

bool isRawTop(double z_mm) {
    return z_mm > -kSameTopMm;
}

double floorOf(const ClearingTask& task, const Toolpath& frame, int depth) {
    return depth == frame.depths ? task.floor_z_mm : task.top_z_mm - depth * frame.step_down_mm;
}

}  // namespace stepmill::toolpath
