// From areas to a path over all depths of cut.

#include <algorithm>
#include <cmath>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/toolpath/toolpath.h"
#include "toolpath/emit.h"
#include "toolpath/layer_script.h"
#include "toolpath/passes.h"
#include "toolpath/ring_family.h"

namespace stepmill {

namespace {

/// Where the cutting data name no ramp angle.
constexpr double kDefaultRampAngleDeg = 3;
/// A depth that exceeds whole steps by no more than this share of a step takes no further layer.
constexpr double kLayerExcess = 1e-9;

int layersFor(double depth_mm, double step_down_mm) {
    if (step_down_mm <= 0) return 1;
    return std::max(1, static_cast<int>(std::ceil(depth_mm / step_down_mm - kLayerExcess)));
}

double rampAngle(const CuttingData& cutting) {
    return degToRad(cutting.ramp_angle_deg > 0 ? cutting.ramp_angle_deg : kDefaultRampAngleDeg);
}

Toolpath emptyPath(const ClearingTask& task, double radius_mm, const CuttingData& cutting,
                   const Machine& machine) {
    Toolpath path;
    path.pattern = "contour-parallel";
    path.step_over_mm = toolpath::usedStepOver(cutting, radius_mm);
    const double depth_mm = task.top_z_mm - task.floor_z_mm;
    path.layers = layersFor(depth_mm, cutting.step_down_mm);
    path.step_down_mm = depth_mm / path.layers;
    const double limit = machine.max_feed_mm_per_min;
    const auto limited = [&](double feed) { return limit > 0 ? std::min(feed, limit) : feed; };
    path.feed_mm_per_min = limited(cutting.feed_mm_per_min);
    path.plunge_feed_mm_per_min = limited(cutting.plunge_feed_mm_per_min > 0 ? cutting.plunge_feed_mm_per_min
                                                                             : cutting.feed_mm_per_min);
    path.ramp_feed_mm_per_min =
        rampFeed(path.feed_mm_per_min, path.plunge_feed_mm_per_min, rampAngle(cutting));
    return path;
}

}  // namespace

Toolpath clearArea(const ClearingTask& task, const ToolAssembly& tool, const CuttingData& cutting,
                   const Machine& machine, const Tolerances& tol) {
    STEPMILL_CHECK(tool.radius_mm() > 0, "a cutter has a diameter");
    STEPMILL_CHECK(cutting.feed_mm_per_min > 0 && machine.rapid_mm_per_min > 0, "feeds are positive");
    STEPMILL_CHECK(task.retract_z_mm >= task.top_z_mm, "retract height below the material");
    Toolpath path = emptyPath(task, tool.radius_mm(), cutting, machine);
    if (task.centres.empty() || task.free_centres.empty() || task.top_z_mm <= task.floor_z_mm) return path;

    using namespace toolpath;
    const std::shared_ptr<const RingFamily> rings =
        task.rings ? task.rings : makeRings(task, tool, cutting, tol);
    STEPMILL_CHECK(rings->radiusMm() == tool.radius_mm() && rings->stepOverMm() == path.step_over_mm,
                   "rings of another tool or step-over");
    const PassSet set = contourParallel(task, *rings, tol);
    if (set.passes.empty()) return path;
    const LinkRates rates{path.feed_mm_per_min, path.plunge_feed_mm_per_min, machine.rapid_mm_per_min,
                          path.step_down_mm + kApproachMm, kApproachMm};
    const std::vector<ScriptStep> script =
        scriptLayer(task, set, tool.radius_mm(), path.step_over_mm, rates, tol);

    const auto levelOf = [&](int layer) {
        return layer == path.layers ? task.floor_z_mm : task.top_z_mm - layer * path.step_down_mm;
    };
    MoveWriter writer(path);
    for (int layer = 1; layer <= path.layers; ++layer)
        writer.writeLayer(script, {levelOf(layer - 1), levelOf(layer), task.top_z_mm, task.retract_z_mm,
                                   rampAngle(cutting)});
    writer.retract();
    path.totals = measure(path, machine);
    return path;
}

}  // namespace stepmill
