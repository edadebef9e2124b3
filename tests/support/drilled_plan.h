#pragma once

#include "support/sample_plan.h"

namespace stepmill::test {

/// The sample plan and three holes: in one go with a dwell, in pecks, and in pecks with a dwell; mist on the
/// first, no coolant on the others.
inline Plan drilledPlan() {
    Plan plan = samplePlan();
    plan.library.tools.push_back(numberedTool("DR5", 5, 5));
    plan.library.tools.back().type = ToolType::Drill;
    CuttingData cutting;
    cutting.feed_mm_per_min = 250;
    cutting.plunge_feed_mm_per_min = 250;
    PlannedSetup& setup = plan.setups.front();
    Vec3 at = setup.operations.back().path.moves.back().to;
    for (int hole = 0; hole < 3; ++hole) {
        cutting.step_down_mm = hole == 0 ? 20 : 3.3333333;
        Operation operation;
        operation.id = "S1.O" + std::to_string(4 + hole);
        operation.setup_id = "S1";
        operation.feature_id = "S1.F" + std::to_string(2 + hole);
        operation.tool_id = "DR5";
        operation.role = Role::Drill;
        operation.speed_rpm = 4000;
        operation.z_floor_mm = -10;
        operation.coolant = hole == 0 ? Coolant::Mist : Coolant::Off;
        operation.dwell_s = hole == 1 ? 0 : 0.5;
        operation.path = drillHole(Vec2(10 + 10 * hole, 40.1234567), 0, -10, 5, plan.library.tools.back(),
                                   cutting, plan.machine);
        const Vec3 over = operation.path.start;
        operation.path.start = at;
        operation.path.moves.insert(operation.path.moves.begin(), rapid(over.x(), over.y(), over.z()));
        operation.path.totals = measure(operation.path, plan.machine);
        at = operation.path.moves.back().to;
        setup.operations.push_back(operation);
    }
    return plan;
}

}  // namespace stepmill::test
