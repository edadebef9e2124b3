#pragma once

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill::test {

inline Machine makeMachine() {
    Machine machine;
    machine.name = "mill";
    machine.rapid_mm_per_min = 10000;
    machine.max_feed_mm_per_min = 8000;
    machine.max_speed_rpm = 20000;
    machine.tool_change_s = 5;
    machine.hourly_rate = 60;
    machine.safe_height_mm = 5;
    machine.dialect = "linuxcnc";
    return machine;
}

inline ToolAssembly makeTool(const std::string& id, ToolType type, double diameter_mm, double feed,
                             double step_down) {
    ToolAssembly tool;
    tool.id = id;
    tool.type = type;
    tool.diameter_mm = diameter_mm;
    tool.flute_length_mm = 40;
    tool.stick_out_mm = 60;
    tool.flutes = 3;
    tool.centre_cutting = true;
    CuttingData cutting;
    cutting.material = "aluminium";
    cutting.step_over_mm = diameter_mm / 2;
    cutting.step_down_mm = step_down;
    cutting.feed_mm_per_min = feed;
    cutting.plunge_feed_mm_per_min = feed / 4;
    cutting.ramp_angle_deg = 3;
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

inline ToolLibrary makeLibrary(std::vector<ToolAssembly> tools) {
    ToolLibrary library;
    library.file = "tools.json";
    library.tools = std::move(tools);
    int number = 0;
    for (ToolAssembly& tool : library.tools)
        tool.number = ++number;
    return library;
}

/// A pocket in a block: the target with walls all round, from z = 0 down.
inline Feature makePocket(const Region& target, double depth_mm,
                          FeatureClass feature_class = FeatureClass::ClosedPocket) {
    const Tolerances tol;
    Feature feature;
    feature.id = "S1.F1";
    feature.setup_id = "S1";
    feature.feature_class = feature_class;
    feature.top_z_mm = 0;
    feature.floor_z_mm = -depth_mm;
    feature.target = target;
    const Box2 block = grown(boundingBox(target), 15);
    feature.obstruction = subtract(makeRectangle(block.min(), block.max()), target, tol);
    feature.obstacles.push_back({feature.floor_z_mm, feature.top_z_mm, feature.obstruction});
    for (const Loop& loop : target.loops)
        feature.boundary.push_back({loop, false});
    feature.closed_length_mm = perimeter(target);
    feature.area_mm2 = area(target);
    feature.volume_mm3 = feature.area_mm2 * depth_mm;
    return feature;
}

/// 70 x 50 mm, corner radius 6, a round island of 16 mm; 12 mm deep.
inline Feature makeIslandPocket() {
    const Tolerances tol;
    const Region pocket = makeRoundedRectangle(Vec2(0, 0), Vec2(70, 50), 6);
    Feature feature = makePocket(subtract(pocket, makeCircle(Vec2(35, 25), 8), tol), 12);
    feature.min_corner_radius_mm = 6;
    return feature;
}

inline SequenceOptions inAluminium(Objective objective = Objective::Time) {
    SequenceOptions options;
    options.material = "aluminium";
    options.objective = objective;
    return options;
}

}  // namespace stepmill::test
