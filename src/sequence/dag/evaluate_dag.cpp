#include "sequence/dag/evaluate_dag.h"

#include <algorithm>

#include "sequence/dag/edge_table.h"
#include "sequence/dag/edge_work.h"
#include "stepmill/sequence/tool_dag.h"

namespace stepmill {
namespace {

/// So many edges are evaluated before it is asked anew which others may pay: enough for the cores of a
/// machine, few enough that what the first ones weigh rules most others out. The first of a feature are
/// fewer: before them nothing rules any out, and a narrow tool's path over all of a wide feature is long to
/// make.
constexpr std::size_t kEdgesAtFirst = 2;
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
        const auto alone = [&](int n) { return task_.tools[n].alone; };
        const auto helped = [&](int n) { return n != kSource && hasSurrogates(n); };
        const auto plain = [&](int n) { return !helped(n) && !alone(n); };
        evaluateToolsAlone();
        evaluateFromSource([&](int n) { return !ends(n) && plain(n); });
        // Where only tools with surrogates can end the feature, the most promising gives a path to beat.
        const int promising = mostPromisingEnd();
        evaluateFromSource([&](int n) { return n == promising; });
        evaluateFromSource(alone);
        evaluateBetween([&](int m, int n) { return !helped(m) && plain(n); });
        evaluateBetween([&](int m, int n) { return !helped(m) && alone(n); });
        // Edges that need surrogates cost most to evaluate: all others give a path to beat first.
        evaluateFromSource([&](int n) { return n != promising && ends(n) && helped(n); });
        evaluateFromSource([&](int n) { return !ends(n) && helped(n); });
        evaluateBetween([&](int m, int n) { return helped(m) && !helped(n); });
        evaluateBetween([&](int, int n) { return helped(n); });
        return result();
    }

  private:
    bool hasSurrogates(int n) const { return task_.tools[n].hasSurrogates(); }
    bool aloneIsKnown() const { return task_.alone_weight < kNoEdge; }

    /// The tools that do the whole feature alone give a complete path to beat. Those that would beat it if
    /// their change were not paid for are evaluated too: another feature may pay for it.
    void evaluateToolsAlone() {
        const auto does_all = [&](int n) { return task_.ends[n] && !hasSurrogates(n); };
        const double change = changeWeight(task_.machine, task_.options.objective);
        if (!aloneIsKnown()) return evaluateFromSource(does_all, change);
        for (int n = 0; n <= last_; ++n)
            if (does_all(n) && table_.exists(kSource, n)) table_.leaveOut(kSource, n);
    }

    /// \param allowed  an edge may weigh so much more than the path to beat lets it
    template <typename Wanted>
    void evaluateFromSource(const Wanted& wanted, double allowed = 0) {
        EdgeList open;
        for (int n = 0; n <= last_; ++n)
            if (table_.exists(kSource, n) && wanted(n)) open.emplace_back(kSource, n);
        evaluate(std::move(open), allowed);
    }

    template <typename Wanted>
    void evaluateBetween(const Wanted& wanted) {
        EdgeList open;
        for (int m = 0; m <= last_; ++m)
            for (int n = m + 1; n <= last_; ++n)
                if (table_.exists(m, n) && wanted(m, n)) open.emplace_back(m, n);
        evaluate(std::move(open), 0);
    }

    /// A few at a time and the most promising first: what they weigh bounds the paths through the others, and
    /// shortens the path to beat.
    void evaluate(EdgeList open, double allowed) {
        while (!open.empty()) {
            const double known = weightToBeat();
            table_.bound();
            leaveOutHopeless(known + allowed, open);
            const std::size_t at_once = known < kNoEdge ? kEdgesAtATime : kEdgesAtFirst;
            pruned_ += table_.evaluate(takeMostPromising(table_, at_once, open), known);
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

}  // namespace stepmill
