#pragma once

#include "support/hole_tool_makers.h"
#include "support/sample_plan.h"

namespace stepmill::test {

/// The sample plan and four operations on two holes: spotted, drilled with chips broken, reamed, and bored
/// with a stay at the bottom.
inline Plan holeCyclePlan() {
    Plan plan = samplePlan();
    PlannedSetup& setup = plan.setups.front();
    const std::vector<Vec2> places{Vec2(10, 40.1234567), Vec2(30, 40.1234567)};
    const auto add = [&](ToolAssembly tool, Role role, double z_mm, Toolpath path, double dwell_s) {
        tool.number = static_cast<int>(plan.library.tools.size()) + 20;
        plan.library.tools.push_back(tool);
        Operation operation;
        operation.id = "S1.O" + std::to_string(setup.operations.size() + 1);
        operation.setup_id = "S1";
        operation.feature_id = "S1.F2";
        operation.tool_id = tool.id;
        operation.role = role;
        operation.speed_rpm = 800;
        operation.z_floor_mm = z_mm;
        operation.holes = 2;
        operation.dwell_s = dwell_s;
        operation.path = std::move(path);
        const Vec3 over = operation.path.start;
        operation.path.start = setup.operations.back().path.moves.back().to;
        operation.path.moves.insert(operation.path.moves.begin(), rapid(over.x(), over.y(), over.z()));
        operation.path.totals = measure(operation.path, plan.machine);
        setup.operations.push_back(operation);
    };
    const ToolAssembly spot = makeSpot(6);
    add(spot, Role::Spot, -3, drillHoles(places, 0, -3, 5, spot, spot.cutting.front(), plan.machine), 0);
    ToolAssembly drill = makeDrill(7);
    drill.cutting.front().step_down_mm = 10;
    drill.cutting.front().plunge_feed_mm_per_min = 300;
    add(drill, Role::Drill, -30, drillHoles(places, 0, -30, 5, drill, drill.cutting.front(), plan.machine),
        0);
    ToolAssembly reamer = makeReamer(8);
    add(reamer, Role::Ream, -28, sizeHoles(places, 0, -28, 5, reamer, reamer.cutting.front(), plan.machine),
        0);
    ToolAssembly head = makeReamer(9);
    head.id = "BH";
    head.type = ToolType::Boring;
    add(head, Role::Bore, -25, sizeHoles(places, 0, -25, 5, head, head.cutting.front(), plan.machine), 0.25);
    return plan;
}

}  // namespace stepmill::test
