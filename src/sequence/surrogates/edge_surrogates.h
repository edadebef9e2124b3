#pragma once

#include <map>
#include <memory>
#include <vector>

#include "sequence/dag/candidate.h"
#include "sequence/surrogates/lump_ways.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

class SolvedLump;
class SurrogateFinder;
using Lumps = std::vector<std::shared_ptr<const SolvedLump>>;

/// The surrogates that clear the lumps of one edge of the tool DAG, and what they weigh.
struct EdgeSurrogates {
    Lumps lumps;
    ChosenWays plain{{}, 0, false};  ///< the cheapest way, whatever follows
    /// By the candidate that follows: ways with it as the last surrogate, where that is cheaper still.
    std::map<int, ChosenWays> before;

    bool possible() const { return plain.weight < kNoEdge; }
    /// What the edge costs less when that candidate follows.
    double saving(int next) const;
    double largestSaving() const;
    const ChosenWays& choice(int next) const;
};

/// The surrogates of edge (m, n) of these candidates (m null: the source).
/// \pre tools[n].hasSurrogates()
/// \param change_weight  of one tool change, seconds or money
EdgeSurrogates surrogatesOfEdge(const SurrogateFinder& finder, const std::vector<Candidate>& tools,
                                const Candidate* m, int n, double change_weight);

/// Adds the surrogates to the edge: their work, time, cost and tool changes, as chosen before candidate
/// `next`.
void addSurrogates(const EdgeSurrogates& surrogates, int next, const Machine& machine, DagEdge& edge);

/// The surrogates in machining order, each visit once.
std::vector<const ToolAssembly*> surrogatesBefore(const EdgeSurrogates& surrogates, int next,
                                                  const SurrogateFinder& finder,
                                                  const std::vector<Candidate>& tools);

/// The surrogates' steps in machining order, proved: by falling diameter, `next`'s own last where it takes
/// part.
/// \throws Error(Internal) if a path gouges
std::vector<SequenceStep> surrogateSteps(const EdgeSurrogates& surrogates, int next,
                                         const SurrogateFinder& finder, const std::vector<Candidate>& tools);

}  // namespace stepmill
