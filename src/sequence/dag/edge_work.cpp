#include "sequence/dag/edge_work.h"

#include "sequence/dag/step_paths.h"
#include "stepmill/sequence/advice/area_models.h"

namespace stepmill {
namespace {

AreaModelTool modelOf(const DagTask& task, const Candidate& tool) {
    return areaModelTool(tool.tool->radius_mm(), tool.coverable_mm2, task.ground.feature().depth_mm(),
                         tool.cutting);
}

/// k of [Yao2000] for all cutters of the feature.
YaoConstants yaoConstants(const DagTask& task) {
    std::vector<AreaModelTool> models;
    for (const Candidate& tool : task.tools)
        if (tool.mills()) models.push_back(modelOf(task, tool));
    return {0, yaoFactorSPerMm(models)};
}

/// Seconds the model gives that area, tool changes left out.
double modelTimeS(const DagTask& task, const Candidate& n, double new_mm2) {
    AreaModelTool work = modelOf(task, n);
    work.area_mm2 = new_mm2;
    work.volume_mm3 = new_mm2 * task.ground.feature().depth_mm();
    return task.options.cost_model == CostModel::Yao ? yaoEdgeS(0, work, yaoConstants(task))
                                                     : limEdgeS(0, work, 0);
}

}  // namespace

bool needsPaths(const DagTask& task) {
    return task.options.cost_model == CostModel::Path;
}

std::optional<EdgeWork> edgeWork(const DagTask& task, const Candidate* m, const Candidate& n,
                                 const SharedRings& rings) {
    if (needsPaths(task) || !n.mills()) {
        const std::vector<SequenceStep> steps = makePaths(task, m, n, rings);
        if (steps.empty()) return std::nullopt;
        EdgeWork work{{}, area(steps.back().area.area), steps.back().area.new_area_mm2};
        for (const SequenceStep& step : steps)
            work.totals += step.path.totals;
        return work;
    }
    const DecomposedArea decomposed =
        decomposedArea(task.ground, m != nullptr ? m->cleared : nullptr, *n.own);
    if (decomposed.centres.empty()) return std::nullopt;
    EdgeWork work;
    work.region_area_mm2 = area(decomposed.area);
    work.new_area_mm2 = decomposed.new_area_mm2;
    work.totals.feed_time_s = modelTimeS(task, n, work.new_area_mm2);
    work.totals.motion_time_s = work.totals.feed_time_s;
    return work;
}

}  // namespace stepmill
