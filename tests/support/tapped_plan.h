#pragma once

#include "support/sample_plan.h"
#include "support/tap_makers.h"

namespace stepmill::test {

/// The sample plan and two holes tapped M8, 15 deep with the lead, on coordinates that do not fall on the
/// program's decimals.
inline Plan tappedPlan() {
    Plan plan = samplePlan();
    ToolAssembly tap = makeTap("M8");
    tap.number = 7;
    plan.library.tools.push_back(tap);
    PlannedSetup& setup = plan.setups.front();
    const std::vector<Vec2> places{Vec2(10, 40.1234567), Vec2(30, 40.1234567)};
    Operation operation;
    operation.id = "S1.O" + std::to_string(setup.operations.size() + 1);
    operation.setup_id = "S1";
    operation.feature_id = "S1.F2";
    operation.tool_id = tap.id;
    operation.role = Role::Tap;
    operation.speed_rpm = 800;
    operation.z_floor_mm = -15;
    operation.holes = 2;
    operation.thread = {*tap.thread, -15, -10, places};
    operation.path = tapHoles(places, 0, -15, 5, tap, operation.speed_rpm, plan.machine);
    const Vec3 over = operation.path.start;
    operation.path.start = setup.operations.back().path.moves.back().to;
    operation.path.moves.insert(operation.path.moves.begin(), rapid(over.x(), over.y(), over.z()));
    operation.path.totals = measure(operation.path, plan.machine);
    setup.operations.push_back(operation);
    return plan;
}

}  // namespace stepmill::test
