#pragma once

#include "support/tool_makers.h"

namespace stepmill::test {

/// A plug tap in a library: 20 mm of cutting part, a neck as thin as its core behind that, at 800 rev/min.
inline ToolAssembly makeTap(const std::string& thread) {
    ToolAssembly tap = bareTool("TAP " + thread, ToolType::Tap, 0);
    tap.thread = threadFrom(thread).value();
    tap.diameter_mm = tap.thread->diameter_mm;
    tap.lead_mm = 4 * tap.thread->pitch_mm;
    tap.flute_length_mm = 20;
    tap.stick_out_mm = 60;
    tap.shank = {coreRange(*tap.thread).least_mm - 0.2, 20, 60};
    CuttingData cutting;
    cutting.material = kMaterial;
    cutting.speed_rpm = 800;
    cutting.feed_mm_per_min = 800 * tap.thread->pitch_mm;
    tap.cutting.push_back(cutting);
    return tap;
}

}  // namespace stepmill::test
