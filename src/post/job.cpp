// From a plan to what posts need.

#include "stepmill/post/post.h"

namespace stepmill {

std::vector<FedMove> fedMoves(const Toolpath& path) {
    std::vector<FedMove> moves;
    moves.reserve(path.moves.size());
    for (const Move& move : path.moves)
        moves.push_back({move, path.feedOf(move.kind)});
    return moves;
}

namespace {

JobOperation operationOf(const Plan& plan, const Operation& operation) {
    JobOperation job;
    job.id = operation.id;
    job.feature_id = operation.feature_id;
    job.role = toString(operation.role);
    job.pattern = operation.path.pattern;
    job.tool = plan.library.tool(operation.tool_id);
    job.layers = operation.path.layers;
    job.step_down_mm = operation.path.step_down_mm;
    job.z_floor_mm = operation.z_floor_mm;
    job.leaves = operation.leaves;
    job.speed_rpm = operation.speed_rpm;
    job.coolant = operation.coolant;
    job.dwell_s = operation.dwell_s;
    job.start = operation.path.start;
    job.moves = fedMoves(operation.path);
    return job;
}

}  // namespace

Job jobOf(const Plan& plan, const PlannedSetup& setup) {
    Job job;
    job.part_name = plan.part.name;
    job.part_file = plan.part.file;
    job.setup_id = setup.setup.id;
    job.axis_name = axisName(setup.setup.axis);
    job.material = plan.material;
    job.machine_name = plan.machine.name;
    job.stock_size_mm = setup.setup.stock_bbox_mm.sizes();
    job.time_s = setup.time_s;
    for (const Operation& operation : setup.operations)
        job.operations.push_back(operationOf(plan, operation));
    return job;
}

std::string program(const Plan& plan, const PlannedSetup& setup) {
    return post(jobOf(plan, setup), {dialectOf(plan.machine)}).front().text;
}

}  // namespace stepmill
