// From a plan to what posts need.

#include "stepmill/post/post.h"

namespace stepmill {

std::vector<FedMove> fedMoves(const Toolpath& path) {
    std::vector<FedMove> moves;
    moves.reserve(path.moves.size());
    for (const Move& move : path.moves)
        moves.push_back({move, path.feedOf(move)});
    return moves;
}

Job jobOf(const Plan& plan, const PlannedSetup& setup) {
    Job job;
    job.part_name = plan.part.name;
    job.part_file = plan.part.file;
    job.setup_id = setup.setup.id;
    job.axis_name = axisName(setup.setup.axis);
    job.material = plan.material;
    job.machine = plan.machine;
    job.stock_size_mm = setup.setup.stock_bbox_mm.sizes();
    job.stock_tolerance_mm = setup.setup.stock.tolerance_mm;
    job.time_s = setup.motion_s;
    for (const Operation& operation : setup.operations)
        job.operations.push_back(
            {sheetOf(operation, plan.library), operation.path.start, fedMoves(operation.path)});
    return job;
}

std::string program(const Plan& plan, const PlannedSetup& setup) {
    return post(jobOf(plan, setup), {dialectOf(plan.machine)}).front().text;
}

}  // namespace stepmill
