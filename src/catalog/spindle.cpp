#include "stepmill/catalog/spindle.h"

namespace stepmill {

double gaugeLengthMm(const ToolAssembly& tool) {
    return tool.holder.empty() ? tool.stick_out_mm : tool.holder.back().top_mm;
}

ToolAssembly inSpindle(ToolAssembly tool, const Machine& machine) {
    const double gauge_mm = gaugeLengthMm(tool);
    for (const HolderCylinder& nose : machine.spindle_nose)
        tool.holder.push_back({nose.diameter_mm, gauge_mm + nose.bottom_mm, gauge_mm + nose.top_mm});
    return tool;
}

}  // namespace stepmill
