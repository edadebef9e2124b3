#pragma once

#include "support/sample_plan.h"

namespace stepmill::test {

/// The sample plan and drilled holes: one in one go with a dwell, one in pecks, one in pecks with a dwell,
/// and three equal ones in one go with dwells; mist on the first, no coolant on the others.
inline Plan drilledPlan() {
    Plan plan = samplePlan();
    plan.library.tools.push_back(numberedTool("DR3", 5, 3));
    plan.library.tools.back().type = ToolType::Drill;
    CuttingData cutting;
    cutting.feed_mm_per_min = 250;
    cutting.plunge_feed_mm_per_min = 250;
    const std::vector<std::vector<Vec2>> holes{{Vec2(10, 40.1234567)},
                                               {Vec2(20, 40.1234567)},
                                               {Vec2(30, 40.1234567)},
                                               {Vec2(30, 10), Vec2(40, 10.7654321), Vec2(40, 20)}};
    PlannedSetup& setup = plan.setups.front();
    Vec3 at = setup.operations.back().path.moves.back().to;
    for (std::size_t i = 0; i < holes.size(); ++i) {
        const bool pecks = i == 1 || i == 2;
        cutting.step_down_mm = pecks ? 3.3333333 : 20;
        Operation operation;
        operation.id = "S1.O" + std::to_string(4 + i);
        operation.setup_id = "S1";
        operation.feature_id = "S1.F" + std::to_string(2 + i);
        operation.tool_id = "DR3";
        operation.role = Role::Drill;
        operation.speed_rpm = 4000;
        operation.z_floor_mm = -10;
        operation.coolant = i == 0 ? Coolant::Mist : Coolant::Off;
        operation.dwell_s = i == 1 ? 0 : 0.5;
        operation.holes = static_cast<int>(holes[i].size());
        operation.path = drillHoles(holes[i], 0, -10, 5, plan.library.tools.back(), cutting, plan.machine);
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
