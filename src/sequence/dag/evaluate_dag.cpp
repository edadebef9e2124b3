#include "sequence/dag/evaluate_dag.h"

#include <algorithm>

#include <fmt/format.h>

#include "sequence/dag/edge_table.h"
#include "sequence/dag/edge_work.h"
#include "sequence/holder/tool_areas.h"
#include "stepmill/core/error.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/spotting.h"
#include "stepmill/sequence/tool_dag.h"

namespace stepmill {
namespace {

/// So many edges are evaluated before it is asked anew which others may pay: enough for the cores of a
/// machine, few enough that what the first ones weigh rules most others out.
constexpr std::size_t kEdgesAtATime = 8;

/// Takes the edges with the least bounds out of `open`; they keep their order.
EdgeList takeMostPromising(const EdgeTable& table, std::size_t count, EdgeList& open) {
    if (open.size() <= count) return std::exchange(open, {});
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < open.size(); ++i)
        order.emplace_back(table.leastThrough(open[i].first, open[i].second), i);
    std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
    std::vector<char> chosen(open.size(), 0);
    for (std::size_t i = 0; i < count; ++i)
        chosen[order[i].second] = 1;
    EdgeList taken;
    EdgeList later;
    for (std::size_t i = 0; i < open.size(); ++i)
        (chosen[i] != 0 ? taken : later).push_back(open[i]);
    open = std::move(later);
    return taken;
}

/// Evaluates edges in rounds. Each round leaves out what cannot beat the cheapest path known by then.
class DagSearch {
  public:
    explicit DagSearch(const DagTask& task)
        : task_(task),
          table_(task),
          last_(static_cast<int>(task.tools.size()) - 1),
          any_with_surrogates_(std::any_of(task.tools.begin(), task.tools.end(),
                                           [](const Candidate& tool) { return tool.hasSurrogates(); })) {}

    DagResult run() {
        const auto ends = [&](int n) { return task_.ends[n]; };
        const auto plain = [&](int n) { return !hasSurrogates(n); };
        evaluateToolsAlone();
        // Edges that need surrogates cost most to evaluate, so they come last from each node.
        evaluate(kSource, kSource, [&](int n) { return !ends(n) && plain(n); });
        // Where only tools with surrogates can end the feature, the most promising gives a path to beat.
        const int promising = mostPromisingEnd();
        evaluate(kSource, kSource, [&](int n) { return n == promising; });
        evaluate(kSource, kSource, [&](int n) { return n != promising && ends(n) && !plain(n); });
        evaluate(kSource, kSource, [&](int n) { return !ends(n) && !plain(n); });
        evaluate(0, last_, plain);
        evaluate(0, last_, [&](int n) { return !plain(n); });
        return result();
    }

  private:
    bool hasSurrogates(int n) const { return task_.tools[n].hasSurrogates(); }
    bool aloneIsKnown() const { return task_.alone_weight < kNoEdge; }

    /// Evaluates every tool that does the whole feature alone: that gives a complete path to beat.
    void evaluateToolsAlone() {
        EdgeList edges;
        for (int n = 0; n <= last_; ++n) {
            if (!task_.ends[n] || hasSurrogates(n) || !table_.exists(kSource, n)) continue;
            if (aloneIsKnown())
                table_.leaveOut(kSource, n);
            else
                edges.emplace_back(kSource, n);
        }
        table_.evaluate(edges, kNoEdge);
    }

    /// Evaluates the edges from these nodes to the tools wanted, a few at a time and the most promising
    /// first: what they weigh bounds the paths through the others, and shortens the path to beat.
    template <typename Wanted>
    void evaluate(int m_first, int m_last, const Wanted& wanted) {
        EdgeList open;
        for (int m = m_first; m <= m_last; ++m)
            for (int n = m + 1; n <= last_; ++n)
                if (table_.exists(m, n) && wanted(n)) open.emplace_back(m, n);
        while (!open.empty()) {
            const double known = weightToBeat();
            table_.bound();
            leaveOutHopeless(known, open);
            pruned_ += table_.evaluate(takeMostPromising(table_, kEdgesAtATime, open), known);
        }
    }

    /// The bounds hold for real paths. An area model may be below them, and costs little to evaluate: all its
    /// edges are.
    double weightToBeat() const {
        return needsPaths(task_) ? std::min(task_.alone_weight, cheapest().cost) : kNoEdge;
    }

    void leaveOutHopeless(double known, EdgeList& open) {
        pruned_ += static_cast<int>(std::erase_if(open, [&](const auto& edge) {
            const bool may = table_.mayBeat(edge.first, edge.second, known);
            if (!may) table_.leaveOut(edge.first, edge.second);
            return !may;
        }));
    }

    /// The tool that ends the feature with surrogates and has the least bound from the source; kSource
    /// without any.
    int mostPromisingEnd() const {
        int best = kSource;
        for (int n = 0; n <= last_; ++n) {
            if (!task_.ends[n] || !hasSurrogates(n) || !table_.exists(kSource, n)) continue;
            const bool first = best == kSource;
            if (first || table_.leastWeight(kSource, n) < table_.leastWeight(kSource, best)) best = n;
        }
        return best;
    }

    CheapestPath cheapest() const {
        const auto weight = [&](int m, int n) { return table_.weight(m, n); };
        const auto saving = [&](int m, int n, int next) { return table_.saving(m, n, next); };
        return cheapestPath(last_ + 1, weight, task_.ends, any_with_surrogates_ ? Saving(saving) : Saving());
    }

    DagResult result() const {
        CheapestPath best = cheapest();
        if (aloneIsKnown() && best.cost >= task_.alone_weight) best = {};
        return {table_.evaluated(), std::move(best.tools), table_.rings(), pruned_, best.cost};
    }

    const DagTask& task_;
    EdgeTable table_;
    int last_;  ///< tool; -1 without any
    bool any_with_surrogates_;
    int pruned_ = 0;
};

}  // namespace

const WeighedEdge* edgeBetween(const DagResult& dag, int from, int to) {
    const auto found = std::lower_bound(dag.edges.begin(), dag.edges.end(), std::pair(from, to),
                                        [](const WeighedEdge& edge, const std::pair<int, int>& wanted) {
                                            return std::pair(edge.from, edge.to) < wanted;
                                        });
    const bool is_there = found != dag.edges.end() && found->from == from && found->to == to;
    return is_there ? &*found : nullptr;
}

DagResult evaluateDag(const DagTask& task) {
    return DagSearch(task).run();
}

namespace {

/// What a mill clears in one go: of the whole depth what the tool before it has left, or, where that was a
/// drill that stayed over a flat floor, what is beside it and then all below.
struct Stretch {
    double top_z_mm = 0;
    double floor_z_mm = 0;
    const Candidate* after = nullptr;
};

std::vector<Stretch> stretchesOf(const DagTask& task, const Candidate* m) {
    const Feature& feature = task.ground.feature();
    if (m == nullptr || !m->predrills || feature.through) return {{feature.top_z_mm, feature.floor_z_mm, m}};
    const double drilled_to_mm = preDrilledToZ(feature, *m->tool);
    return {{feature.top_z_mm, drilled_to_mm, m}, {drilled_to_mm, feature.floor_z_mm, nullptr}};
}

/// The clearing task of edge (m, n): the area that n sweeps after m.
ClearingTask clearingTask(const DagTask& task, const Candidate& n, const Stretch& stretch,
                          const DecomposedArea& decomposed, Pattern pattern, const SharedRings& rings) {
    const Feature& feature = task.ground.feature();
    ClearingTask clearing = clearingTaskOf(feature, task.around, *n.own, task.retract_z_mm);
    clearing.entries = n.own->entries;
    clearing.slot_middles = n.own->slot_middles;
    clearing.in_slot =
        stretch.after != nullptr && !stretch.after->predrills && !stretch.after->own->slot_middles.empty();
    clearing.centres = decomposed.centres;
    clearing.cleared_centres = decomposed.cleared_centres;
    // The plan may set the tool out shorter than the library allows: it takes the shortest stick-out that
    // works.
    addHolder(feature, *n.tool, clearing);
    // Below where a hole was drilled first its own walls stand over the stretch.
    if (stretch.top_z_mm < feature.top_z_mm) clearing.stands_above.reset();
    clearing.top_z_mm = stretch.top_z_mm;
    clearing.floor_z_mm = stretch.floor_z_mm;
    clearing.pattern = pattern;
    clearing.patterns = task.options.patterns;
    clearing.rings = rings;
    return clearing;
}

/// The step without its path.
SequenceStep stepOf(const DagTask& task, const Stretch& stretch, const Candidate& n) {
    SequenceStep step;
    step.tool_id = n.tool->id;
    step.speed_rpm = n.cutting.speed_rpm;
    step.area =
        decomposedArea(task.ground, stretch.after != nullptr ? stretch.after->cleared : nullptr, *n.own);
    step.leaves.floors_mm = stretch.floor_z_mm - task.ground.feature().floor_z_mm;
    return step;
}

Toolpath pathBy(Pattern pattern, const DagTask& task, const Candidate& n, const Stretch& stretch,
                const DecomposedArea& decomposed, const SharedRings& rings) {
    if (decomposed.centres.empty()) return {};
    return clearArea(clearingTask(task, n, stretch, decomposed, pattern, rings), *n.tool, n.cutting,
                     task.machine, task.ground.tolerances());
}

SequenceStep drilledBy(const DagTask& task, const Candidate& n) {
    const Feature& feature = task.ground.feature();
    if (n.spots) return spotStep(feature, *n.tool, n.cutting, task.retract_z_mm, task.machine);
    return n.predrills ? preDrillStep(feature, *n.tool, n.cutting, task.retract_z_mm, task.machine,
                                      task.ground.tolerances())
                       : drillStep(feature, *n.tool, n.cutting, task.retract_z_mm, task.machine);
}

SharedRings ringsBy(Pattern pattern, const DagTask& task, const Candidate& n, const Stretch& stretch) {
    return makeRings(clearingTask(task, n, stretch, {}, pattern, nullptr), *n.tool, n.cutting,
                     task.ground.tolerances());
}

/// Each region takes its own quickest pattern; the links between the regions may cost more than that saves.
Toolpath quickestPath(const DagTask& task, const Candidate& n, const Stretch& stretch,
                      const DecomposedArea& decomposed) {
    if (decomposed.centres.empty()) return {};
    // Rings for any pattern have those of the weighed one among them.
    const SharedRings rings = ringsBy(task.options.pattern, task, n, stretch);
    Toolpath path = pathBy(task.options.pattern, task, n, stretch, decomposed, rings);
    // Where every region took the weighed pattern this is its path.
    if (path.pattern == toString(kWeighedPattern)) return path;
    Toolpath weighed = pathBy(kWeighedPattern, task, n, stretch, decomposed, rings);
    const auto weight = [&](const Toolpath& one) {
        return weightOf(edgeCost(one.totals, *n.tool, task.machine), task.options.objective);
    };
    return weight(weighed) < weight(path) ? weighed : path;
}

double adaptiveSpeedRpm(const CuttingData& cutting) {
    const bool own = cutting.adaptive && cutting.adaptive->speed_rpm > 0;
    return own ? cutting.adaptive->speed_rpm : cutting.speed_rpm;
}

/// The step of one stretch, proved.
SequenceStep milledBy(const DagTask& task, const Candidate* m, const Candidate& n, const Stretch& stretch) {
    const Feature& feature = task.ground.feature();
    const Tolerances& tol = task.ground.tolerances();
    SequenceStep step = stepOf(task, stretch, n);
    step.path = quickestPath(task, n, stretch, step.area);
    if (step.path.engagement_rad > 0) step.speed_rpm = adaptiveSpeedRpm(n.cutting);
    const bool facing = feature.feature_class == FeatureClass::Face;
    step.role = m != nullptr ? Role::Rest : facing ? Role::Face : Role::Rough;
    step.proof = prove(step.path, clearingTask(task, n, stretch, step.area, task.options.pattern, nullptr),
                       n.tool->radius_mm(), tol);
    if (step.proof.least_clearance_mm < -tol.gouge_mm) {
        throw Error(ErrorCode::Internal, feature.id,
                    fmt::format("the path of tool {} would cut {:.4f} mm into what must stay", n.tool->id,
                                -step.proof.least_clearance_mm));
    }
    return step;
}

}  // namespace

SharedRings ringsOf(const DagTask& task, const Candidate& tool) {
    if (!tool.mills()) return nullptr;
    return ringsBy(kWeighedPattern, task, tool, stretchesOf(task, nullptr).front());
}

std::vector<SequenceStep> makePaths(const DagTask& task, const Candidate* m, const Candidate& n,
                                    const SharedRings& rings) {
    if (!n.mills()) return {drilledBy(task, n)};
    std::vector<SequenceStep> steps;
    for (const Stretch& stretch : stretchesOf(task, m)) {
        SequenceStep step = stepOf(task, stretch, n);
        step.path = pathBy(kWeighedPattern, task, n, stretch, step.area, rings);
        if (!step.path.moves.empty()) steps.push_back(std::move(step));
    }
    return steps;
}

std::vector<SequenceStep> makeSteps(const DagTask& task, const Candidate* m, const Candidate& n) {
    if (!n.mills()) return {drilledBy(task, n)};
    std::vector<SequenceStep> steps;
    const std::vector<Stretch> stretches = stretchesOf(task, m);
    for (const Stretch& stretch : stretches) {
        SequenceStep step = milledBy(task, m, n, stretch);
        if (stretches.size() == 1 || !step.path.moves.empty()) steps.push_back(std::move(step));
    }
    return steps;
}

SequenceStep makeStep(const DagTask& task, const Candidate* m, const Candidate& n) {
    return makeSteps(task, m, n).front();
}

}  // namespace stepmill
