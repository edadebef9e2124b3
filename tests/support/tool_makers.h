#pragma once

#include <string>
#include <utility>
#include <vector>

#include "stepmill/catalog/tool.h"

namespace stepmill::test {

/// What the made tools' cutting data are for.
inline constexpr const char* kMaterial = "aluminium";

/// A tool of that diameter with nothing else said: all other makers begin with it.
inline ToolAssembly bareTool(const std::string& id, ToolType type, double diameter_mm) {
    ToolAssembly tool;
    tool.id = id;
    tool.type = type;
    tool.diameter_mm = diameter_mm;
    return tool;
}

/// Cuts at 1000 mm/min, plunges at 300, ramps at 3 degrees.
inline CuttingData cuttingData(double step_over_mm, double step_down_mm) {
    CuttingData cutting;
    cutting.material = kMaterial;
    cutting.step_over_mm = step_over_mm;
    cutting.step_down_mm = step_down_mm;
    cutting.feed_mm_per_min = 1000;
    cutting.plunge_feed_mm_per_min = 300;
    cutting.ramp_angle_deg = 3;
    return cutting;
}

/// A centre-cutting flat end mill for paths alone: without cutting data or a holder.
inline ToolAssembly flatEndMill(double diameter_mm) {
    ToolAssembly tool = bareTool("flat", ToolType::Flat, diameter_mm);
    tool.flute_length_mm = 50;
    tool.centre_cutting = true;
    return tool;
}

/// The same with cutting data, long enough for anything.
inline ToolAssembly endMill(double diameter_mm) {
    ToolAssembly tool = bareTool("T" + std::to_string(diameter_mm), ToolType::Flat, diameter_mm);
    tool.flute_length_mm = 100;
    tool.stick_out_mm = 100;
    tool.flutes = 2;
    tool.centre_cutting = true;
    CuttingData data = cuttingData(diameter_mm / 2, 2);
    data.feed_mm_per_min = 500;
    data.plunge_feed_mm_per_min = 200;
    data.speed_rpm = 8000;
    tool.cutting.push_back(data);
    return tool;
}

/// A tool of a library: 40 mm of flutes, 60 mm out of a holder that is not modelled, half its diameter to the
/// side.
inline ToolAssembly makeTool(const std::string& id, ToolType type, double diameter_mm, double feed,
                             double step_down) {
    ToolAssembly tool = bareTool(id, type, diameter_mm);
    tool.flute_length_mm = 40;
    tool.stick_out_mm = 60;
    tool.flutes = 3;
    tool.centre_cutting = true;
    CuttingData cutting = cuttingData(diameter_mm / 2, step_down);
    cutting.feed_mm_per_min = feed;
    cutting.plunge_feed_mm_per_min = feed / 4;
    cutting.speed_rpm = 10000;
    tool.cutting.push_back(cutting);
    return tool;
}

inline ToolAssembly makeMill(double diameter_mm, double feed = 1200, double step_down = 4) {
    return makeTool("EM" + std::to_string(static_cast<int>(diameter_mm)), ToolType::Flat, diameter_mm, feed,
                    step_down);
}

inline ToolAssembly makeDrill(double diameter_mm) {
    return makeTool("DR" + std::to_string(static_cast<int>(diameter_mm)), ToolType::Drill, diameter_mm, 300,
                    0);
}

inline ToolAssembly bullNoseMill(double diameter_mm, double corner_radius_mm, double feed = 1200,
                                 double step_down = 4) {
    ToolAssembly tool = makeTool("BN" + std::to_string(static_cast<int>(diameter_mm)), ToolType::Bull,
                                 diameter_mm, feed, step_down);
    tool.corner_radius_mm = corner_radius_mm;
    return tool;
}

inline ToolAssembly ballMill(double diameter_mm, double feed = 1200, double step_down = 2) {
    ToolAssembly tool = bullNoseMill(diameter_mm, diameter_mm / 2, feed, step_down);
    tool.id = "BM" + std::to_string(static_cast<int>(diameter_mm));
    tool.type = ToolType::Ball;
    return tool;
}

inline ToolAssembly chamferMill(double diameter_mm, double tip_diameter_mm, double included_angle_deg,
                                double feed = 800) {
    ToolAssembly tool = makeTool("CM" + std::to_string(static_cast<int>(diameter_mm)), ToolType::Chamfer,
                                 diameter_mm, feed, 2);
    tool.tip_diameter_mm = tip_diameter_mm;
    tool.included_angle_deg = included_angle_deg;
    return tool;
}

/// The tool in a holder of one cylinder, `height_mm` high, which begins where the tool sticks out.
inline ToolAssembly inHolder(ToolAssembly tool, double stick_out_mm, double holder_diameter_mm,
                             double height_mm = 40) {
    tool.stick_out_mm = stick_out_mm;
    tool.holder = {{holder_diameter_mm, stick_out_mm, stick_out_mm + height_mm}};
    return tool;
}

inline ToolLibrary makeLibrary(std::vector<ToolAssembly> tools) {
    ToolLibrary library;
    library.file = "tools.json";
    library.tools = std::move(tools);
    int number = 0;
    for (ToolAssembly& tool : library.tools)
        tool.number = ++number;
    return library;
}

}  // namespace stepmill::test
