#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "sequence/dag/edge_work.h"
#include "sequence/dag/evaluate_dag.h"
#include "sequence/surrogates/shelf.h"

namespace stepmill {

using EdgeList = std::vector<std::pair<int, int>>;  ///< node numbers, from and to

/// The edges of one feature's tool DAG while they are evaluated: each with its weight where that is known,
/// else with a lower bound of it. Weights are seconds or money, as the objective asks.
class EdgeTable {
  public:
    /// \param task  stays as it is while the table is used
    explicit EdgeTable(const DagTask& task);

    /// Evaluates the edges listed; all others stay as they are. For an edge that needs surrogates n's own
    /// path is made first; the edge is left out where it cannot beat `known` even if its lumps took the least
    /// time. Returns how many were left out.
    /// \pre bound() was called, or `known` is kNoEdge
    int evaluate(const EdgeList& edges, double known);

    /// kNoEdge where the edge was not evaluated, or is none.
    double weight(int m, int n) const { return slot(m, n).weight; }
    /// What edge (m, n) costs less when `next` follows.
    double saving(int m, int n, int next) const { return slot(m, n).surrogates.saving(next); }
    /// Of each tool; null where no evaluated edge leads to it.
    const std::vector<SharedRings>& rings() const { return rings_; }
    /// The edges that have a weight, by from, then to.
    std::vector<WeighedEdge> evaluated() const;

    /// Bounds the ways to and from every tool from below, by the weights that are known and the lower bounds
    /// of the others.
    void bound();

    /// Removes the edge from all further search.
    void leaveOut(int m, int n) { slot(m, n).settled = true; }
    /// False where an edge needs no evaluation because it cannot exist.
    bool exists(int m, int n) const { return slot(m, n).least_weight < kNoEdge; }
    /// Can a path through the edge be as cheap as `known`?
    /// \pre bound() was called
    bool mayBeat(int m, int n, double known) const;
    /// Lower bound of the weight of all paths through the edge.
    /// \pre bound() was called
    double leastThrough(int m, int n) const;
    /// Lower bound of the edge's own weight.
    double leastWeight(int m, int n) const { return slot(m, n).least_weight; }

  private:
    struct Slot {
        DagEdge edge;
        EdgeSurrogates surrogates;
        double weight = kNoEdge;
        double least_weight = kNoEdge;  ///< lower bound of the weight, whatever tool follows
        bool settled = false;           ///< evaluated or left out

        /// The weight before the tool that lets the edge save most.
        double lowestWeight() const { return weight - surrogates.largestSaving(); }
        /// Lower bound of what the edge adds to a path; kNoEdge where the edge is out of the search.
        double bound() const { return settled ? lowestWeight() : least_weight; }
    };

    Slot& slot(int m, int n) { return slots_[static_cast<std::size_t>(m + 1) * n_ + n]; }
    const Slot& slot(int m, int n) const { return slots_[static_cast<std::size_t>(m + 1) * n_ + n]; }
    const Candidate* tool(int m) const { return m == kSource ? nullptr : &task_.tools[m]; }
    int sameWork(int n) const;
    void makeMissingRings(const EdgeList& edges);
    bool evaluate(int m, int n, double known, Slot& into) const;
    double leastOnward(int n) const;
    double leastAfter(int n, double lumps_mm2) const;
    bool mayBeatWithLumps(int m, int n, double own_weight, double own_new_mm2, double known) const;

    const DagTask& task_;
    int n_;  ///< tools
    std::vector<Slot> slots_;
    std::vector<SharedRings> rings_;
    /// Of edges, without what surrogates do on them.
    Shelf<std::pair<int, int>, std::optional<EdgeWork>> works_;
    std::vector<double> to_tool_;  ///< lower bounds of the ways from the source to each tool
    std::vector<double> to_sink_;  ///< lower bounds of the ways from each tool to the sink
    /// leastOnward() of each tool before the edges of a round are evaluated, which must not read each other's
    /// slots: they are, by several threads, in any order.
    std::vector<double> onward_;
};

}  // namespace stepmill
