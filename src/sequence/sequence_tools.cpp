#include <tbb/parallel_for.h>

#include "sequence/candidate.h"
#include "sequence/drilling.h"
#include "sequence/evaluate_dag.h"
#include "sequence/lower_bound.h"
#include "sequence/residuals.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {
namespace {

/// Areas of all tools. A drill of the hole's own size takes part although the area calculus turns it away.
std::vector<AccessibleArea> areasOfAllTools(const FeatureGround& ground, const ToolLibrary& library,
                                            const SequenceOptions& options) {
    const std::vector<const ToolAssembly*> tools = byFallingDiameter(library);
    std::vector<AccessibleArea> areas(tools.size());
    tbb::parallel_for(std::size_t{0}, tools.size(), [&](std::size_t i) {
        areas[i] = accessibleArea(ground, *tools[i], options.material);
        if (!tools[i]->isDrill() || tools[i]->cuttingFor(options.material) == nullptr) return;
        const DrillCheck check = drillCheck(ground.feature(), *tools[i], ground.tolerances());
        if (check.fits) {
            areas[i].excluded.reset();
        } else if (check.excluded) {
            areas[i].excluded = check.excluded;
        } else if (!areas[i].excluded) {
            areas[i].excluded = Exclusion{ExclusionReason::WrongType, "is wider than the hole"};
        }
    });
    return areas;
}

std::vector<SequenceStep> makeSteps(const DagTask& task, const DagResult& dag) {
    const std::vector<int>& path = dag.path;
    std::vector<SequenceStep> steps(path.size());
    tbb::parallel_for(std::size_t{0}, path.size(), [&](std::size_t i) {
        const Candidate* before = i == 0 ? nullptr : &task.tools[path[i - 1]];
        steps[i] = makeStep(task, before, task.tools[path[i]], dag.rings[path[i]]);
    });
    return steps;
}

}  // namespace

ToolSequence sequenceTools(const Feature& feature, const ToolLibrary& library, const Machine& machine,
                           const SequenceOptions& options, const Tolerances& tol) {
    const FeatureGround ground(feature, tol);
    ToolSequence sequence;
    sequence.feature_id = feature.id;
    sequence.tools = areasOfAllTools(ground, library, options);

    const std::vector<Candidate> tools = usableTools(feature, sequence.tools, library, options, machine, tol);
    if (tools.empty()) {
        sequence.residual.push_back(wholeFeature(ground, sequence.tools, library));
        return sequence;
    }
    const std::vector<bool> ends = endTools(feature, tools, tol);
    // z = 0 is the stock's top, so the height over it is the retract plane's z.
    const double retract_z = options.retract_mm > 0 ? options.retract_mm : machine.safe_height_mm;
    const DagTask task{ground, tools, ends, options, machine, retract_z};
    const DagResult dag = evaluateDag(task);
    sequence.edges = dag.edges;
    sequence.pruned_edges = dag.pruned;
    if (dag.path.empty()) {
        sequence.residual.push_back(wholeFeature(ground, sequence.tools, library));
        return sequence;
    }
    sequence.steps = makeSteps(task, dag);
    for (std::size_t i = 0; i < dag.path.size(); ++i) {
        const EdgeCost cost = edgeCost(sequence.steps[i].path.totals, *tools[dag.path[i]].tool, machine);
        sequence.time_s += cost.time_s;
        sequence.cost += cost.cost;
    }
    const TimeBounds bounds = timeBounds(feature, tools, ends, machine, tol);
    sequence.lower_bound_s = bounds.with_changes_s;
    sequence.cutting_bound_s = bounds.cutting_s;
    sequence.residual = leftOver(ground, tools[dag.path.back()]);
    return sequence;
}

}  // namespace stepmill
