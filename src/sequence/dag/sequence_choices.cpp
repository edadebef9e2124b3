#include "sequence/dag/sequence_choices.h"

#include <algorithm>

#include <tbb/parallel_for.h>

#include "sequence/steps/finishing.h"
#include "sequence/steps/residuals.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/tool_dag.h"

namespace stepmill {
namespace {

/// Partial ways looked at for a feature, and ways kept; beyond these only the cheapest found are offered.
constexpr int kMostWaysSeen = 20000;
constexpr std::size_t kMostWaysKept = 24;

double changeWeight(const SequenceChoices& from) {
    return weightOf(machineCost(from.machine.tool_change_s, from.machine), from.options.objective);
}

bool isWithin(const std::vector<std::string>& few, const std::vector<std::string>& many) {
    auto next = few.begin();
    for (const std::string& tool : many)
        if (next != few.end() && *next == tool) ++next;
    return next == few.end();
}

/// Is b no better than a, whatever other features call?
bool isNoBetter(const SequenceChoice& b, const SequenceChoice& a) {
    return a.paths <= b.paths && isWithin(a.tools, b.tools);
}

double leastStickOut(const DagTask& task, const Candidate& tool) {
    if (!tool.drill()) return leastStickOutMm(task.ground, *tool.tool, tool.own());
    return leastStickOutMm(*tool.tool, [&](const ToolAssembly& shorter) {
        return drillCheck(task.ground.feature(), shorter, task.ground.tolerances()).fits;
    });
}

}  // namespace

SequenceChoices::SequenceChoices(FeatureGround from, const SequenceOptions& asked, const Machine& mill,
                                 const ToolLibrary& owned, double retract_z)
    : ground(std::move(from)), options(asked), machine(mill), library(owned), retract_z_mm(retract_z) {}

std::vector<const Candidate*> SequenceChoices::usedOn(const std::vector<int>& path) const {
    std::vector<const Candidate*> used;
    for (const int node : path)
        used.push_back(&tools[node]);
    return used;
}

const std::vector<Residual>& SequenceChoices::left() const {
    std::call_once(left_once_, [&] { left_ = leftOver(ground, usedOn(dag.path), withheld); });
    return left_;
}

const std::vector<SequenceChoice>& SequenceChoices::choices() const {
    std::call_once(listed_, [&] { list(); });
    return choices_;
}

const WeighedEdge* SequenceChoices::edgeBetween(int from, int to) const {
    const auto found = std::lower_bound(dag.edges.begin(), dag.edges.end(), std::pair(from, to),
                                        [](const WeighedEdge& edge, const std::pair<int, int>& wanted) {
                                            return std::pair(edge.from, edge.to) < wanted;
                                        });
    const bool is_there = found != dag.edges.end() && found->from == from && found->to == to;
    return is_there ? &*found : nullptr;
}

std::vector<std::string> SequenceChoices::visitsOn(const std::vector<int>& path) const {
    std::vector<std::string> visits;
    const auto visit = [&](const std::string& tool) {
        if (visits.empty() || visits.back() != tool) visits.push_back(tool);
    };
    for (std::size_t i = 0; i < path.size(); ++i) {
        const WeighedEdge* edge = edgeBetween(i == 0 ? kSource : path[i - 1], path[i]);
        visit(tools[path[i]].tool->id);
        const int next = i + 1 < path.size() ? path[i + 1] : static_cast<int>(tools.size());
        for (const std::string& helper : helpersBefore(edge->help, next, *finder, tools))
            visit(helper);
    }
    return visits;
}

/// Ways that end with the same tool, or that all leave nothing, leave the same: but for tools that are
/// limited, which leave more than the last tool does.
bool SequenceChoices::leavesTheSame(const std::vector<int>& path) const {
    if (path == dag.path) return true;
    const auto limited = [&](int node) { return !tools[node].area->limited.empty(); };
    if (std::any_of(path.begin(), path.end(), limited) ||
        std::any_of(dag.path.begin(), dag.path.end(), limited))
        return false;
    if (path.back() == dag.path.back()) return true;
    return left().empty() && leftOver(ground, usedOn(path), withheld).empty();
}

void SequenceChoices::addChoice(const std::vector<int>& path, double weight) const {
    SequenceChoice choice;
    choice.tools = visitsOn(path);
    choice.paths = weight - static_cast<double>(choice.tools.size()) * changeWeight(*this);
    const bool known = std::any_of(choices_.begin(), choices_.end(),
                                   [&](const SequenceChoice& other) { return isNoBetter(choice, other); });
    if (known || !leavesTheSame(path)) return;
    choices_.push_back(std::move(choice));
    paths_.push_back(path);
}

/// All ways on from `path`, whose edges but the last weigh `weight`, as long as their paths alone take no
/// more than the whole of the feature's own optimum: others are worse in every company.
void SequenceChoices::addWays(std::vector<int>& path, double weight) const {
    const int n = static_cast<int>(tools.size());
    const int before = path.size() < 2 ? kSource : path[path.size() - 2];
    const int last = path.empty() ? kSource : path.back();
    const WeighedEdge* edge = path.empty() ? nullptr : edgeBetween(before, last);
    if (++seen_ > kMostWaysSeen) return;
    if (edge != nullptr && ends[last]) addChoice(path, weight + edge->weightBefore(n));
    for (int next = last + 1; next < n; ++next) {
        const WeighedEdge* on = edgeBetween(last, next);
        if (on == nullptr) continue;
        const double so_far = weight + (edge != nullptr ? edge->weightBefore(next) : 0);
        const auto changes = static_cast<double>(path.empty() ? 0 : visitsOn(path).size());
        if (so_far - changes * changeWeight(*this) > dag.weight) continue;
        path.push_back(next);
        addWays(path, so_far);
        path.pop_back();
    }
}

void SequenceChoices::list() const {
    addChoice(dag.path, dag.weight);
    std::vector<int> path;
    addWays(path, 0);
    // The feature's own stays first; of the others those that are dearest by themselves go.
    std::vector<std::size_t> order(choices_.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    const auto alone = [&](std::size_t i) {
        return choices_[i].paths + static_cast<double>(choices_[i].tools.size()) * changeWeight(*this);
    };
    std::stable_sort(order.begin() + 1, order.end(),
                     [&](std::size_t a, std::size_t b) { return alone(a) < alone(b); });
    if (order.size() > kMostWaysKept) order.resize(kMostWaysKept);
    std::vector<SequenceChoice> kept;
    std::vector<std::vector<int>> paths;
    for (const std::size_t i : order) {
        kept.push_back(std::move(choices_[i]));
        paths.push_back(std::move(paths_[i]));
    }
    choices_ = std::move(kept);
    paths_ = std::move(paths);
}

namespace {

/// All edges; those on the path as they are before the tool that follows there, others before the sink.
std::vector<DagEdge> listEdges(const SequenceChoices& from, const std::vector<int>& path) {
    const int n = static_cast<int>(from.tools.size());
    std::map<std::pair<int, int>, int> next_on_path;
    for (std::size_t i = 0; i + 1 < path.size(); ++i)
        next_on_path[{i == 0 ? kSource : path[i - 1], path[i]}] = path[i + 1];
    std::vector<DagEdge> edges;
    auto edge = from.dag.edges.begin();
    for (int m = kSource; m < n; ++m) {
        for (; edge != from.dag.edges.end() && edge->from == m; ++edge) {
            const auto next = next_on_path.find({m, edge->to});
            DagEdge listed = edge->edge;
            addHelp(edge->help, next == next_on_path.end() ? n : next->second, from.machine, listed);
            edges.push_back(std::move(listed));
        }
        if (m == kSource || !from.ends[m]) continue;
        DagEdge to_sink;
        to_sink.from = from.tools[m].tool->id;
        edges.push_back(to_sink);
    }
    return edges;
}

void addUp(const SequenceChoices& from, ToolSequence& sequence) {
    sequence.time_s = sequence.cost = sequence.motion_s = 0;
    std::string last;
    for (const SequenceStep& step : sequence.steps) {
        const ToolAssembly& tool = from.library.tool(step.tool_id);
        const EdgeCost cost = edgeCost(step.path.totals, tool, from.machine);
        const EdgeCost change = edgeCost({}, tool, from.machine);
        const bool stays = step.tool_id == last;
        sequence.time_s += cost.time_s - (stays ? change.time_s : 0);
        sequence.cost += cost.cost - (stays ? change.cost : 0);
        sequence.motion_s += cost.motion_s - (stays ? change.motion_s : 0);
        last = step.tool_id;
    }
}

}  // namespace

void SequenceChoices::take(std::size_t index, ToolSequence& sequence) const {
    const std::vector<int>& path = index == 0 ? dag.path : paths_.at(index);
    AllowanceSteps finished = stepsWithAllowance(task(), usedOn(path));
    sequence.no_allowance = std::move(finished.less);
    sequence.steps = finished.steps.empty() ? stepsOn(path) : std::move(finished.steps);
    sequence.edges = listEdges(*this, path);
    addUp(*this, sequence);
}

std::vector<SequenceStep> SequenceChoices::stepsOn(const std::vector<int>& path) const {
    const DagTask on = task();
    // Every tool's step and after it those of its surrogates.
    std::vector<std::vector<SequenceStep>> steps(path.size());
    tbb::parallel_for(std::size_t{0}, path.size(), [&](std::size_t i) {
        const Candidate& tool = tools[path[i]];
        const Candidate* before = i == 0 ? nullptr : &tools[path[i - 1]];
        steps[i].push_back(makeStep(on, before, tool));
        steps[i].back().least_stick_out_mm = leastStickOut(on, tool);
        const int next = i + 1 < path.size() ? path[i + 1] : static_cast<int>(tools.size());
        const WeighedEdge& edge = *edgeBetween(i == 0 ? kSource : path[i - 1], path[i]);
        for (SequenceStep& step : helpSteps(edge.help, next, *finder, tools))
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
