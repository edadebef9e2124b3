#include "stepmill/catalog/spindle.h"

#include <algorithm>

namespace stepmill {
namespace {

/// The point of the curve at which the spindle first gives its most.
const SpindlePoint& cornerOf(const std::vector<SpindlePoint>& curve) {
    return *std::max_element(curve.begin(), curve.end(), [](const SpindlePoint& a, const SpindlePoint& b) {
        return a.power_kw < b.power_kw;
    });
}

double powerAt(const std::vector<SpindlePoint>& curve, double speed_rpm) {
    if (speed_rpm > curve.back().speed_rpm) return 0;
    const auto above = std::find_if(curve.begin(), curve.end(),
                                    [&](const SpindlePoint& point) { return point.speed_rpm >= speed_rpm; });
    if (above == curve.begin()) return above->power_kw * speed_rpm / above->speed_rpm;
    const SpindlePoint& below = *(above - 1);
    const double share = (speed_rpm - below.speed_rpm) / (above->speed_rpm - below.speed_rpm);
    return below.power_kw + share * (above->power_kw - below.power_kw);
}

}  // namespace

double gaugeLengthMm(const ToolAssembly& tool) {
    return tool.holder.empty() ? tool.stick_out_mm : tool.holder.back().top_mm;
}

ToolAssembly inSpindle(ToolAssembly tool, const Machine& machine) {
    tool.holder_clearance_mm = machine.holder_clearance_mm;
    const double gauge_mm = gaugeLengthMm(tool);
    for (const HolderCylinder& nose : machine.spindle_nose)
        tool.holder.push_back({nose.diameter_mm, gauge_mm + nose.bottom_mm, gauge_mm + nose.top_mm});
    return tool;
}

std::optional<SpindlePower> spindlePower(const Machine& machine, double speed_rpm) {
    const std::vector<SpindlePoint>& curve = machine.spindle_curve;
    if (curve.empty()) return std::nullopt;
    return SpindlePower{powerAt(curve, speed_rpm), speed_rpm < cornerOf(curve).speed_rpm};
}

}  // namespace stepmill
