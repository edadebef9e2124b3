#pragma once

#include "support/tool_makers.h"

namespace stepmill::test {

/// A spot drill of 90 degrees.
inline ToolAssembly makeSpot(double diameter_mm) {
    ToolAssembly spot =
        makeTool("SP" + std::to_string(static_cast<int>(diameter_mm)), ToolType::Spot, diameter_mm, 600, 0);
    spot.point_angle_deg = kUsualSpotPointDeg;
    return spot;
}

/// A drill that starts true by itself.
inline ToolAssembly selfCentringDrill(double diameter_mm) {
    ToolAssembly drill = makeDrill(diameter_mm);
    drill.point_angle_deg = 140;
    drill.self_centring = true;
    return drill;
}

/// A reamer with a lead of 1 mm that goes slowly.
inline ToolAssembly makeReamer(double diameter_mm) {
    ToolAssembly reamer = makeTool("RM", ToolType::Reamer, diameter_mm, 200, 0);
    reamer.lead_mm = 1;
    return reamer;
}

}  // namespace stepmill::test
