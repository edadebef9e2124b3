#include "sequence/dag/sequence_choices.h"

#include <algorithm>
#include <map>

#include "sequence/dag/step_paths.h"
#include "sequence/steps/finishing.h"
#include "sequence/steps/residuals.h"
#include "stepmill/core/parallel.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/spotting.h"
#include "stepmill/sequence/tool_dag.h"

namespace stepmill {
namespace {

/// The rings of all tools are most of what weighing takes of memory, and steps make their own.
DagResult withoutRings(DagResult dag) {
    dag.rings.clear();
    return dag;
}

double leastStickOut(const DagTask& task, const Candidate& tool) {
    if (tool.mills()) return leastStickOutMm(task.ground, *tool.tool, *tool.own);
    return leastStickOutMm(*tool.tool, [&](const ToolAssembly& shorter) {
        const Feature& feature = task.ground.feature();
        const Tolerances& tol = task.ground.tolerances();
        if (tool.spots) return spotFits(feature, shorter);
        return tool.predrills ? preDrills(feature, shorter, tol) : drillCheck(feature, shorter, tol).fits;
    });
}

/// All edges; those on the path as they are before the tool that follows there, others before the sink.
std::vector<DagEdge> listEdges(const DagTask& task, const DagResult& dag, const std::vector<int>& path) {
    const int n = static_cast<int>(task.tools.size());
    std::map<std::pair<int, int>, int> next_on_path;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        next_on_path[{i == 0 ? kSource : path[i - 1], path[i]}] = path[i + 1];
    std::vector<DagEdge> edges;
    auto edge = dag.edges.begin();
    for (int m = kSource; m < n; ++m) {
        for (; edge != dag.edges.end() && edge->from == m; ++edge) {
            const auto next = next_on_path.find({m, edge->to});
            DagEdge listed = edge->edge;
            addSurrogates(edge->surrogates, next == next_on_path.end() ? n : next->second, task.machine,
                          listed);
            edges.push_back(std::move(listed));
        }
        if (m == kSource || !task.ends[m]) continue;
        DagEdge to_sink;
        to_sink.from = task.tools[m].node();
        edges.push_back(to_sink);
    }
    return edges;
}

void addUp(const SequenceJob& job, ToolSequence& sequence) {
    sequence.time_s = sequence.cost = sequence.motion_s = 0;
    std::string last;
    for (const SequenceStep& step : sequence.steps) {
        const ToolAssembly& tool = job.library.tool(step.tool_id);
        const EdgeCost cost = edgeCost(step.path.totals, tool, job.machine);
        const EdgeCost change = edgeCost({}, tool, job.machine);
        const bool stays = step.tool_id == last;
        sequence.time_s += cost.time_s - (stays ? change.time_s : 0);
        sequence.cost += cost.cost - (stays ? change.cost : 0);
        sequence.motion_s += cost.motion_s - (stays ? change.motion_s : 0);
        last = step.tool_id;
    }
}

}  // namespace

SequenceChoices::SequenceChoices(std::shared_ptr<const SequenceJob> job, Admission admission,
                                 std::optional<Withheld> withheld)
    : job_(std::move(job)),
      admission_(std::move(admission)),
      withheld_(std::move(withheld)),
      tools_(usableTools(job_->feature(), admission_.reaches, job_->library, job_->options, job_->machine,
                         job_->tolerances())),
      ends_(endTools(job_->feature(), tools_, job_->tolerances())),
      dag_(tools_.empty() ? DagResult{} : withoutRings(evaluateDag(task()))),
      residuals_(empty() ? std::vector<Residual>{}
                         : residualsOf(job_->ground, usedOn(dag_.path), withheld_)) {}

DagTask SequenceChoices::task() const {
    DagTask task{
        job_->ground,           tools_, ends_, job_->around, job_->options, job_->machine, job_->retract_z_mm,
        admission_.finder.get()};
    task.first_at_least_mm = job_->options.first_at_least_mm;
    return task;
}

std::vector<const Candidate*> SequenceChoices::usedOn(const std::vector<int>& path) const {
    std::vector<const Candidate*> used;
    for (const int node : path)
        used.push_back(&tools_[node]);
    return used;
}

TimeBounds SequenceChoices::bounds() const {
    return timeBounds(job_->feature(), tools_, ends_, job_->machine, job_->tolerances());
}

/// Do the tools before the last one take nothing that it does not reach? Only limited ones may.
bool SequenceChoices::lastReachesAll(const std::vector<int>& path) const {
    const Tolerances& tol = job_->tolerances();
    return std::all_of(path.begin(), path.end() - 1, [&](int node) {
        const auto within = [&] {
            return covers(tools_[path.back()].cleared->coverable, tools_[node].cleared->coverable,
                          tol.sliver_mm, tol);
        };
        return !tools_[node].isLimited() || within_.get({node, path.back()}, within);
    });
}

/// Ways that end with the same tool, or that all leave nothing, leave the same where the last tool reaches
/// all.
bool SequenceChoices::leavesTheSame(const std::vector<int>& path) const {
    if (path == dag_.path) return true;
    if (!lastReachesAll(path) || !lastReachesAll(dag_.path)) return false;
    if (path.back() == dag_.path.back()) return true;
    return residuals_.empty() && residualsOf(job_->ground, usedOn(path), withheld_).empty();
}

const std::vector<Way>& SequenceChoices::ways() const {
    std::call_once(listed_, [&] {
        const double change = changeWeight(job_->machine, job_->options.objective);
        ways_ = listWays({dag_, tools_, ends_, *admission_.finder, change,
                          [&](const std::vector<int>& path) { return leavesTheSame(path); }});
    });
    return ways_;
}

std::vector<SequenceChoice> SequenceChoices::choices() const {
    std::vector<SequenceChoice> choices;
    for (const Way& way : ways()) {
        SequenceChoice choice;
        for (const ToolAssembly* tool : way.visits)
            choice.tools.push_back(tool->id);
        choice.paths = way.paths;
        choices.push_back(std::move(choice));
    }
    return choices;
}

void SequenceChoices::take(std::size_t index, ToolSequence& sequence) const {
    const std::vector<int>& path = index == 0 ? dag_.path : ways().at(index).path;
    AllowanceSteps finished = stepsWithAllowance(task(), usedOn(path));
    sequence.no_allowance = std::move(finished.less);
    sequence.steps = finished.steps.empty() ? stepsOn(path) : std::move(finished.steps);
    sequence.edges = listEdges(task(), dag_, path);
    sequence.way.clear();
    for (const Candidate* tool : usedOn(path))
        sequence.way.push_back(tool->node());
    addUp(*job_, sequence);
}

std::vector<SequenceStep> SequenceChoices::stepsOn(const std::vector<int>& path) const {
    const DagTask on = task();
    // Every tool's step and after it those of its surrogates.
    std::vector<std::vector<SequenceStep>> steps(path.size());
    parallelFor(path.size(), [&](std::size_t i) {
        const Candidate& tool = tools_[path[i]];
        const Candidate* before = i == 0 ? nullptr : &tools_[path[i - 1]];
        steps[i] = makeSteps(on, before, tool);
        const double stick_out_mm = leastStickOut(on, tool);
        for (SequenceStep& step : steps[i])
            step.least_stick_out_mm = stick_out_mm;
        const int next = i + 1 < path.size() ? path[i + 1] : static_cast<int>(tools_.size());
        const WeighedEdge& edge = *edgeBetween(dag_, i == 0 ? kSource : path[i - 1], path[i]);
        for (SequenceStep& step : surrogateSteps(edge.surrogates, next, *admission_.finder, tools_))
            steps[i].push_back(std::move(step));
    });
    std::vector<SequenceStep> all;
    for (std::vector<SequenceStep>& of_edge : steps)
        std::move(of_edge.begin(), of_edge.end(), std::back_inserter(all));
    return all;
}

std::vector<SequenceChoice> choicesOf(const ToolSequence& sequence) {
    return sequence.choices ? sequence.choices->choices() : std::vector<SequenceChoice>{};
}

ToolSequence withChoice(const ToolSequence& sequence, std::size_t index) {
    ToolSequence other = sequence;
    sequence.choices->take(index, other);
    return other;
}

}  // namespace stepmill
