#pragma once

#include <vector>

#include "sequence/dag/candidate.h"
#include "sequence/holder/tool_areas.h"
#include "sequence/surrogates/edge_surrogates.h"
#include "stepmill/sequence/tool_dag.h"

namespace stepmill {

class SurrogateFinder;
using SharedRings = std::shared_ptr<const RingFamily>;

/// The tools and settings of one feature, which the evaluation of every edge of its DAG needs.
struct DagTask {
    const FeatureGround& ground;
    const std::vector<Candidate>& tools;
    const std::vector<bool>& ends;
    const Surroundings& around;
    const SequenceOptions& options;
    const Machine& machine;
    double retract_z_mm = 0;
    /// Finds the surrogates of tools that have lumps; null where no tool has any.
    const SurrogateFinder* surrogates = nullptr;
    /// Weight of the cheapest tool that does the whole feature alone; kNoEdge: not known. Where it is known,
    /// the search is for cheaper sequences of several tools only.
    double alone_weight = kNoEdge;
    /// Narrower mills do not come first, where any tool is as wide [mm].
    double first_at_least_mm = 0;
};

/// An evaluated edge. Its weight still depends on the node after it.
struct WeighedEdge {
    int from = 0;  ///< node numbers
    int to = 0;
    DagEdge edge;  ///< without its surrogates
    EdgeSurrogates surrogates;
    double weight = 0;  ///< seconds or money, changes included

    /// The weight if that node follows.
    double weightBefore(int next) const { return weight - surrogates.saving(next); }
};

/// All evaluated edges of a feature's tool DAG and its cheapest path.
struct DagResult {
    std::vector<WeighedEdge> edges;  ///< by from, then to
    std::vector<int> path;           ///< node numbers
    std::vector<SharedRings> rings;  ///< of each node; null where no edge led to it
    int pruned = 0;
    double weight = kNoEdge;  ///< of the path: seconds or money
};

/// The edge between two nodes; null where none was evaluated.
const WeighedEdge* edgeBetween(const DagResult& dag, int from, int to);

/// Evaluates the edges on real tool paths, in parallel, and finds the cheapest path. The result is the same
/// for any number of threads: every edge has its own slot, and pruning depends on earlier rounds only.
DagResult evaluateDag(const DagTask& task);

}  // namespace stepmill
