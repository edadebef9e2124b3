#include "sequence/dag/evaluate_dag.h"

#include <set>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "sequence/dag/edge_work.h"
#include "sequence/holder/tool_areas.h"
#include "sequence/surrogates/surrogates.h"
#include "stepmill/core/error.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/tool_dag.h"

namespace stepmill {
namespace {

/// A slot of the edge table. Weights are seconds or money, as the objective asks.
struct EdgeSlot {
    DagEdge edge;
    EdgeSurrogates surrogates;
    double weight = kNoEdge;        ///< kNoEdge until evaluated, and for good if there is no such edge
    double least_weight = kNoEdge;  ///< lower bound of the weight, whatever tool follows
    bool settled = false;           ///< evaluated or left out

    /// The weight before the tool that lets the edge save most.
    double lowestWeight() const { return weight - surrogates.largestSaving(); }
    /// What a path through it counts at least; kNoEdge where it need not be looked at any more.
    double bound() const { return settled ? lowestWeight() : least_weight; }
};

class EdgeTable {
  public:
    explicit EdgeTable(const DagTask& task) : task_(task), n_(static_cast<int>(task.tools.size())) {
        slots_.resize(static_cast<std::size_t>(n_ + 1) * n_);
        rings_.resize(n_);
        for (int m = kSource; m < n_; ++m) {
            for (int n = m + 1; n < n_; ++n)
                slot(m, n).least_weight = leastWeight(m, n);
        }
    }

    /// Evaluates the edges listed; every other slot stays as it is. Of edges that need surrogates n's own
    /// path comes first, and those that cannot beat `known` even if their lumps took the least time are left
    /// out after it. Returns how many. \pre bound() was called, or `known` is kNoEdge
    int evaluate(const std::vector<std::pair<int, int>>& edges, double known) {
        makeMissingRings(edges);
        std::vector<char> left_out(edges.size(), 0);
        tbb::parallel_for(std::size_t{0}, edges.size(), [&](std::size_t i) {
            const auto [m, n] = edges[i];
            slot(m, n).settled = true;
            left_out[i] = evaluate(m, n, known, slot(m, n)) ? 0 : 1;
        });
        return static_cast<int>(std::count(left_out.begin(), left_out.end(), 1));
    }

    double weight(int m, int n) const { return slot(m, n).weight; }
    double saving(int m, int n, int next) const { return slot(m, n).surrogates.saving(next); }
    const std::vector<SharedRings>& rings() const { return rings_; }
    std::vector<WeighedEdge> evaluated() const {
        std::vector<WeighedEdge> edges;
        for (int m = kSource; m < n_; ++m) {
            for (int n = m + 1; n < n_; ++n) {
                const EdgeSlot& at = slot(m, n);
                if (at.weight < kNoEdge) edges.push_back({m, n, at.edge, at.surrogates, at.weight});
            }
        }
        return edges;
    }

    /// Cheapest conceivable ways to and from every tool: from true weights where these are known, else from
    /// the edges' lower bounds.
    void bound() {
        to_tool_.assign(n_, kNoEdge);
        for (int n = 0; n < n_; ++n) {
            to_tool_[n] = slot(kSource, n).bound();
            for (int m = 0; m < n; ++m)
                to_tool_[n] = std::min(to_tool_[n], to_tool_[m] + slot(m, n).bound());
        }
        to_sink_.assign(n_, kNoEdge);
        for (int m = n_; m-- > 0;) {
            if (task_.ends[m]) to_sink_[m] = 0;
            for (int n = m + 1; n < n_; ++n)
                to_sink_[m] = std::min(to_sink_[m], slot(m, n).bound() + to_sink_[n]);
        }
    }

    /// The edge is not looked at again.
    void leaveOut(int m, int n) { slot(m, n).settled = true; }

    /// Is there such an edge, and could a path through it be as cheap as `known`? \pre bound() was called
    bool mayBeat(int m, int n, double known) const {
        const double least = leastThrough(m, n);
        return least < kNoEdge && least <= known;
    }

    /// What the cheapest conceivable path through the edge weighs. \pre bound() was called
    double leastThrough(int m, int n) const {
        const double before = m == kSource ? 0 : to_tool_[m];
        return before + slot(m, n).least_weight + to_sink_[n];
    }

    /// The tool of those wanted with the least bound of its edge from the source; kSource without any.
    template <typename Wanted>
    int mostPromising(const Wanted& wanted) const {
        int best = kSource;
        for (int n = 0; n < n_; ++n) {
            if (!wanted(n) || !exists(kSource, n)) continue;
            if (best == kSource || slot(kSource, n).least_weight < slot(kSource, best).least_weight) best = n;
        }
        return best;
    }

    bool exists(int m, int n) const { return slot(m, n).least_weight < kNoEdge; }

  private:
    EdgeSlot& slot(int m, int n) { return slots_[static_cast<std::size_t>(m + 1) * n_ + n]; }
    const EdgeSlot& slot(int m, int n) const { return slots_[static_cast<std::size_t>(m + 1) * n_ + n]; }

    /// The edges into one tool share its rings; only tools that some edge leads to need any.
    void makeMissingRings(const std::vector<std::pair<int, int>>& edges) {
        std::set<int> missing;
        for (const auto& [m, n] : edges) {
            if (!rings_[n] && !task_.tools[n].drill() && needsPaths(task_)) missing.insert(n);
        }
        const std::vector<int> tools(missing.begin(), missing.end());
        tbb::parallel_for(std::size_t{0}, tools.size(),
                          [&](std::size_t i) { rings_[tools[i]] = ringsOf(task_, task_.tools[tools[i]]); });
    }

    double weigh(const EdgeCost& cost) const { return weightOf(cost, task_.options.objective); }

    /// What tool n covers and m does not must at least be cut at the best rate: what n reaches itself by n,
    /// the rest by the fastest of its surrogates. n is called once. What a surrogate saves is no more than
    /// its own change, which is left out.
    double leastWeight(int m, int n) const {
        const Candidate& to = task_.tools[n];
        const Candidate* from = m == kSource ? nullptr : &task_.tools[m];
        if (from != nullptr && (to.drill() || from->drill())) return kNoEdge;
        const Feature& feature = task_.ground.feature();
        const double from_mm2 = from != nullptr ? from->coverable_mm2 : 0;
        const double new_mm2 = to.coverable_mm2 - from_mm2;
        if (new_mm2 <= sameArea(feature, task_.ground.tolerances())) return kNoEdge;
        if (to.hasSurrogates()) return weightWithLumps(to, new_mm2, to.own->coverable_area_mm2 - from_mm2);
        PathTotals least;
        least.feed_time_s = new_mm2 * feature.depth_mm() / to.volume_rate_mm3_per_s;
        return weigh(edgeCost(least, *to.tool, task_.machine));
    }

    /// A surrogate may wear less than n, so only machine time counts.
    double weightWithLumps(const Candidate& to, double new_mm2, double own_new_mm2) const {
        const double own_mm2 = std::clamp(own_new_mm2, 0.0, new_mm2);
        const double depth_mm = task_.ground.feature().depth_mm();
        const double least_s = own_mm2 * depth_mm / to.volume_rate_mm3_per_s +
                               (new_mm2 - own_mm2) * depth_mm / to.joint_rate_mm3_per_s;
        return changeWeight(to) + weigh(machineCost(least_s, task_.machine));
    }

    double changeWeight(const Candidate& to) const { return weigh(edgeCost({}, *to.tool, task_.machine)); }

    /// Could a path through the edge be as cheap as `known`, given n's own path?
    bool mayBeatWithLumps(int m, int n, double own_weight, double own_new_mm2, double known) const {
        if (known == kNoEdge) return true;
        const Candidate& to = task_.tools[n];
        const double from_mm2 = m == kSource ? 0 : task_.tools[m].coverable_mm2;
        const double lumps_mm2 = std::max(0.0, to.coverable_mm2 - from_mm2 - own_new_mm2);
        const double lumps_s = lumps_mm2 * task_.ground.feature().depth_mm() / to.joint_rate_mm3_per_s;
        const double before = m == kSource ? 0 : to_tool_[m];
        return before + own_weight + weigh(machineCost(lumps_s, task_.machine)) + to_sink_[n] <= known;
    }

    /// False when the edge was left out.
    bool evaluate(int m, int n, double known, EdgeSlot& into) const {
        const Candidate& to = task_.tools[n];
        const Candidate* from = m == kSource ? nullptr : &task_.tools[m];
        const auto work = edgeWork(task_, from, to, rings_[n]);
        if (!work) return true;
        const EdgeCost cost = edgeCost(work->totals, *to.tool, task_.machine);
        if (to.hasSurrogates() && task_.surrogates != nullptr) {
            if (!mayBeatWithLumps(m, n, weigh(cost), work->new_area_mm2, known)) return false;
            into.surrogates = surrogatesOfEdge(*task_.surrogates, task_.tools, from, n, changeWeight(to));
            if (!into.surrogates.possible()) return true;
        }
        into.edge.from = from != nullptr ? from->tool->id : std::string();
        into.edge.to = to.tool->id;
        into.edge.region_area_mm2 = work->region_area_mm2;
        into.edge.totals = work->totals;
        into.edge.time_s = cost.time_s;
        into.edge.cost = cost.cost;
        into.edge.motion_s = cost.motion_s;
        into.weight = weigh(cost) + into.surrogates.plain.weight;
        return true;
    }

    const DagTask& task_;
    int n_;
    std::vector<EdgeSlot> slots_;
    std::vector<SharedRings> rings_;
    std::vector<double> to_tool_;
    std::vector<double> to_sink_;
};

/// Where a tool that does all alone is known only what beats it counts, so few edges at a time, the most
/// promising first, leave out most of the others. Else every way that may pay is worth knowing: tools are
/// shared between features.
std::size_t firstPortion(const DagTask& task, std::size_t edges) {
    constexpr std::size_t kFew = 4;
    return task.alone_weight < kNoEdge ? kFew : edges;
}

/// Moves the edges with the least bounds from `open`, in their order there.
std::vector<std::pair<int, int>> takeMostPromising(const EdgeTable& table, std::size_t count,
                                                   std::vector<std::pair<int, int>>& open) {
    if (open.size() <= count) return std::exchange(open, {});
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < open.size(); ++i)
        order.emplace_back(table.leastThrough(open[i].first, open[i].second), i);
    std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(count), order.end());
    std::vector<char> chosen(open.size(), 0);
    for (std::size_t i = 0; i < count; ++i)
        chosen[order[i].second] = 1;
    std::vector<std::pair<int, int>> taken;
    std::vector<std::pair<int, int>> later;
    for (std::size_t i = 0; i < open.size(); ++i)
        (chosen[i] != 0 ? taken : later).push_back(open[i]);
    open = std::move(later);
    return taken;
}

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
    const int n_tools = static_cast<int>(task.tools.size());
    EdgeTable table(task);
    DagResult result;
    const bool any_with_surrogates = std::any_of(task.tools.begin(), task.tools.end(),
                                                 [](const Candidate& tool) { return tool.hasSurrogates(); });
    const auto cheapest = [&] {
        const auto weight = [&](int m, int n) { return table.weight(m, n); };
        const auto saving = [&](int m, int n, int next) { return table.saving(m, n, next); };
        return cheapestPath(n_tools, weight, task.ends, any_with_surrogates ? Saving(saving) : Saving());
    };
    const auto hasSurrogates = [&](int n) { return task.tools[n].hasSurrogates(); };

    // First every tool that can do the whole feature alone: that gives a complete path to beat.
    const bool alone_known = task.alone_weight < kNoEdge;
    std::vector<std::pair<int, int>> round;
    for (int n = 0; n < n_tools; ++n) {
        if (!task.ends[n] || hasSurrogates(n)) continue;
        if (alone_known)
            table.leaveOut(kSource, n);
        else
            round.emplace_back(kSource, n);
    }
    table.evaluate(round, kNoEdge);

    // Then the others, leaving out what cannot beat it; edges that need surrogates cost most to evaluate.
    const auto addRound = [&](int m_first, int m_last, const auto& wanted) {
        std::vector<std::pair<int, int>> open;
        for (int m = m_first; m <= m_last; ++m)
            for (int n = m + 1; n < n_tools; ++n)
                if (table.exists(m, n) && wanted(n)) open.emplace_back(m, n);
        for (std::size_t size = firstPortion(task, open.size()); !open.empty(); size *= 2) {
            // The bounds hold for real paths; an area model may be below them, and costs little to evaluate.
            const double known = needsPaths(task) ? std::min(task.alone_weight, cheapest().cost) : kNoEdge;
            table.bound();
            result.pruned += static_cast<int>(std::erase_if(open, [&](const auto& edge) {
                const bool may = table.mayBeat(edge.first, edge.second, known);
                if (!may) table.leaveOut(edge.first, edge.second);
                return !may;
            }));
            round = takeMostPromising(table, size, open);
            result.pruned += table.evaluate(round, known);
        }
    };
    addRound(kSource, kSource, [&](int n) { return !task.ends[n] && !hasSurrogates(n); });
    // Where only tools with surrogates can end the feature, the one that promises most gives the plan to
    // beat.
    const int promising = table.mostPromising([&](int n) { return task.ends[n] && hasSurrogates(n); });
    addRound(kSource, kSource, [&](int n) { return n == promising; });
    addRound(kSource, kSource, [&](int n) { return n != promising && task.ends[n] && hasSurrogates(n); });
    addRound(kSource, kSource, [&](int n) { return !task.ends[n] && hasSurrogates(n); });
    addRound(0, n_tools - 1, [&](int n) { return !hasSurrogates(n); });
    addRound(0, n_tools - 1, hasSurrogates);

    CheapestPath best = cheapest();
    if (alone_known && best.cost >= task.alone_weight) best = {};
    result.path = best.tools;
    result.weight = best.cost;
    result.edges = table.evaluated();
    result.rings = table.rings();
    return result;
}

namespace {

/// The clearing job of edge (m, n): what n sweeps after m.
ClearingTask clearingTask(const DagTask& task, const Candidate& n, const DecomposedArea& decomposed,
                          Pattern pattern, const SharedRings& rings) {
    const Feature& feature = task.ground.feature();
    ClearingTask clearing;
    clearing.free_centres = n.own->free_centres;
    clearing.entries = n.own->entries;
    clearing.centres = decomposed.centres;
    clearing.cleared_centres = decomposed.cleared_centres;
    clearing.target = feature.target;
    clearing.obstruction = n.own->obstructionIn(feature);
    // The plan may set the tool out less far than it can be, and then takes the shortest that will do.
    addHolder(feature, *n.tool, clearing);
    clearing.top_z_mm = feature.top_z_mm;
    clearing.floor_z_mm = feature.floor_z_mm;
    clearing.retract_z_mm = task.retract_z_mm;
    clearing.pattern = pattern;
    clearing.rings = rings;
    return clearing;
}

/// The step without its path.
SequenceStep stepOf(const DagTask& task, const Candidate* m, const Candidate& n) {
    SequenceStep step;
    step.tool_id = n.tool->id;
    step.speed_rpm = n.cutting.speed_rpm;
    step.area = decomposedArea(task.ground, m != nullptr ? m->cleared : nullptr, *n.own);
    return step;
}

Toolpath pathBy(Pattern pattern, const DagTask& task, const Candidate& n, const DecomposedArea& decomposed,
                const SharedRings& rings) {
    if (decomposed.centres.empty()) return {};
    return clearArea(clearingTask(task, n, decomposed, pattern, rings), *n.tool, n.cutting, task.machine,
                     task.ground.tolerances());
}

SequenceStep drilledBy(const DagTask& task, const Candidate& n) {
    return drillStep(task.ground.feature(), *n.tool, n.cutting, task.retract_z_mm, task.machine);
}

}  // namespace

SharedRings ringsOf(const DagTask& task, const Candidate& tool) {
    if (tool.drill()) return nullptr;
    return makeRings(clearingTask(task, tool, {}, kWeighedPattern, nullptr), *tool.tool, tool.cutting,
                     task.ground.tolerances());
}

SequenceStep makePath(const DagTask& task, const Candidate* m, const Candidate& n, const SharedRings& rings) {
    if (n.drill()) return drilledBy(task, n);
    SequenceStep step = stepOf(task, m, n);
    step.path = pathBy(kWeighedPattern, task, n, step.area, rings);
    return step;
}

SequenceStep makeStep(const DagTask& task, const Candidate* m, const Candidate& n) {
    const Feature& feature = task.ground.feature();
    const Tolerances& tol = task.ground.tolerances();
    if (n.drill()) return drilledBy(task, n);
    SequenceStep step = stepOf(task, m, n);
    step.path = pathBy(task.options.pattern, task, n, step.area, nullptr);
    // Regions choose for themselves; what lies between them may cost more than they save.
    Toolpath weighed = pathBy(kWeighedPattern, task, n, step.area, nullptr);
    const auto weight = [&](const Toolpath& path) {
        return weightOf(edgeCost(path.totals, *n.tool, task.machine), task.options.objective);
    };
    if (weight(weighed) < weight(step.path)) step.path = std::move(weighed);
    const bool facing = feature.feature_class == FeatureClass::Face;
    step.role = m != nullptr ? Role::Rest : facing ? Role::Face : Role::Rough;
    step.proof = prove(step.path, clearingTask(task, n, step.area, task.options.pattern, nullptr),
                       n.tool->radius_mm(), tol);
    if (step.proof.least_clearance_mm < -tol.gouge_mm) {
        throw Error(ErrorCode::Internal, feature.id,
                    fmt::format("the path of tool {} would cut {:.4f} mm into what must stay", n.tool->id,
                                -step.proof.least_clearance_mm));
    }
    return step;
}

}  // namespace stepmill
