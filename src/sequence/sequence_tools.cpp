#include <tbb/parallel_for.h>

#include "sequence/candidate.h"
#include "sequence/drilling.h"
#include "sequence/evaluate_dag.h"
#include "sequence/holder_limits.h"
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

double mostCovered(const std::vector<Candidate>& tools) {
    double most_mm2 = 0;
    for (const Candidate& tool : tools)
        most_mm2 = std::max(most_mm2, tool.coverable_mm2);
    return most_mm2;
}

struct Job {
    const ToolLibrary& library;
    const Machine& machine;
    const SequenceOptions& options;
    const Tolerances& tol;
};

void addUp(const std::vector<Candidate>& tools, const DagResult& dag, const Machine& machine,
           ToolSequence& sequence) {
    for (std::size_t i = 0; i < dag.path.size(); ++i) {
        const EdgeCost cost = edgeCost(sequence.steps[i].path.totals, *tools[dag.path[i]].tool, machine);
        sequence.time_s += cost.time_s;
        sequence.cost += cost.cost;
    }
}

ToolSequence sequenceTo(const Feature& feature, const Job& job, bool may_end_higher);

/// The steps down to where tools reach, and the rest as residual.
ToolSequence sequenceAbove(const Feature& feature, const Shallower& reached, const Job& job) {
    ToolSequence sequence = sequenceTo(withFloor(feature, reached.floor_z_mm), job, false);
    sequence.residual.push_back(belowReach(feature, reached));
    return sequence;
}

ToolSequence sequenceTo(const Feature& feature, const Job& job, bool may_end_higher) {
    const FeatureGround ground(feature, job.tol);
    ToolSequence sequence;
    sequence.feature_id = feature.id;
    sequence.floor_z_mm = feature.floor_z_mm;
    sequence.tools = areasOfAllTools(ground, job.library, job.options);
    const auto usable = [&] {
        return usableTools(feature, sequence.tools, job.library, job.options, job.machine, job.tol);
    };
    const std::vector<AccessibleArea> unlimited = sequence.tools;
    const std::optional<Withheld> withheld =
        admitLimited(ground, job.library, mostCovered(usable()), sequence.tools);
    const std::vector<Candidate> tools = usable();
    if (may_end_higher) {
        const double known_mm3 = mostCovered(tools) * feature.depth_mm();
        if (const auto reached = shallower(ground, job.library, unlimited, known_mm3)) {
            ToolSequence above = sequenceAbove(feature, *reached, job);
            if (!above.steps.empty()) return above;
        }
    }
    if (tools.empty()) {
        sequence.residual.push_back(wholeFeature(ground, sequence.tools, job.library));
        return sequence;
    }
    const std::vector<bool> ends = endTools(feature, tools, job.tol);
    // z = 0 is the stock's top, so the height over it is the retract plane's z.
    const double retract_z = job.options.retract_mm > 0 ? job.options.retract_mm : job.machine.safe_height_mm;
    const DagTask task{ground, tools, ends, job.options, job.machine, retract_z};
    const DagResult dag = evaluateDag(task);
    sequence.edges = dag.edges;
    sequence.pruned_edges = dag.pruned;
    if (dag.path.empty()) {
        sequence.residual.push_back(wholeFeature(ground, sequence.tools, job.library));
        return sequence;
    }
    sequence.steps = makeSteps(task, dag);
    addUp(tools, dag, job.machine, sequence);
    const TimeBounds bounds = timeBounds(feature, tools, ends, job.machine, job.tol);
    sequence.lower_bound_s = bounds.with_changes_s;
    sequence.cutting_bound_s = bounds.cutting_s;
    std::vector<const Candidate*> used;
    for (const int index : dag.path)
        used.push_back(&tools[index]);
    sequence.residual = leftOver(ground, used, withheld);
    return sequence;
}

}  // namespace

ToolSequence sequenceTools(const Feature& feature, const ToolLibrary& library, const Machine& machine,
                           const SequenceOptions& options, const Tolerances& tol) {
    return sequenceTo(feature, {library, machine, options, tol}, true);
}

}  // namespace stepmill
