#pragma once

#include "stepmill/post/post.h"
#include "support/tool_makers.h"

namespace stepmill::test {

inline Move rapid(double x, double y, double z) {
    return {MoveKind::Rapid, Vec3(x, y, z), std::nullopt, false};
}
inline Move feedTo(double x, double y, double z) {
    return {MoveKind::Feed, Vec3(x, y, z), std::nullopt, false};
}
inline Move plungeTo(double x, double y, double z) {
    return {MoveKind::Plunge, Vec3(x, y, z), std::nullopt, false};
}
inline Move arcTo(double x, double y, double z, const Vec2& centre, double radius, bool ccw,
                  MoveKind kind = MoveKind::Feed) {
    return {kind, Vec3(x, y, z), Arc{centre, radius, ccw}, false};
}

inline ToolAssembly numberedTool(const std::string& id, int number, double diameter_mm) {
    ToolAssembly tool = bareTool(id, ToolType::Flat, diameter_mm);
    tool.number = number;
    tool.stick_out_mm = 30;
    return tool;
}

inline Operation makeOperation(const std::string& id, const std::string& tool, const Machine& machine,
                               const Vec3& start, std::vector<Move> moves) {
    Operation operation;
    operation.id = id;
    operation.setup_id = "S1";
    operation.feature_id = "S1.F1";
    operation.tool_id = tool;
    operation.speed_rpm = 8000;
    operation.path.start = start;
    operation.path.moves = std::move(moves);
    operation.path.pattern = "contour-parallel";
    operation.path.depths = 1;
    operation.path.step_down_mm = 2;
    operation.path.feed_mm_per_min = 1200;
    operation.path.plunge_feed_mm_per_min = 300;
    operation.path.ramp_feed_mm_per_min = 900;
    operation.path.totals = measure(operation.path, machine);
    return operation;
}

/// A helix, a full circle, an arc of 300 degrees, lines and rapids with two tools, on coordinates that do
/// not fall on the program's decimals.
inline Plan samplePlan() {
    Plan plan;
    plan.part.file = "part.step";
    plan.part.name = "Halter (links) \xC3\xB6 100%";
    plan.material = "aluminium";
    plan.machine.name = "mill";
    plan.machine.rapid_mm_per_min = 10000;
    plan.machine.tool_change_s = 5;
    plan.machine.dialect = "linuxcnc";
    plan.library.tools = {numberedTool("EM10", 3, 10), numberedTool("EM6", 12, 6)};
    PlannedSetup setup;
    setup.setup.id = "S1";
    setup.setup.stock_bbox_mm = Box3(Vec3(0, 0, -20), Vec3(100, 50, 0));
    const Vec2 c(30.0000004, 20.1234567);
    const double r = 7.7777777;
    const double angle = 300.0 * 3.14159265358979 / 180;
    setup.operations.push_back(
        makeOperation("S1.O1", "EM10", plan.machine, Vec3(c.x() + r, c.y(), 5),
                      {rapid(c.x() + r, c.y(), 1), plungeTo(c.x() + r, c.y(), 0),
                       arcTo(c.x() + r, c.y(), -2.00005, c, r, true, MoveKind::Ramp),
                       arcTo(c.x() + r, c.y(), -2.00005, c, r, true),
                       arcTo(c.x() + r * std::cos(angle), c.y() + r * std::sin(angle), -2.00005, c, r, true),
                       feedTo(60.33333333, 21.1, -2.00005), rapid(60.33333333, 21.1, 5)}));
    setup.operations.push_back(makeOperation(
        "S1.O2", "EM10", plan.machine, Vec3(60.33333333, 21.1, 5),
        {rapid(10, 10, 5), plungeTo(10, 10, -1), feedTo(20, 10, -1), arcTo(22, 12, -1, Vec2(20, 12), 2, true),
         arcTo(24, 14, -1, Vec2(24, 12), 2, false), rapid(24, 14, 5)}));
    setup.operations.push_back(makeOperation("S1.O3", "EM6", plan.machine, Vec3(24, 14, 5),
                                             {rapid(70, 40, 5), plungeTo(70, 40, -3), rapid(70, 40, 5)}));
    plan.setups.push_back(setup);
    return plan;
}

}  // namespace stepmill::test
