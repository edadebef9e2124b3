#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "sequence/dag/candidate.h"
#include "sequence/dag/evaluate_dag.h"
#include "sequence/dag/job.h"
#include "sequence/surrogates/lump_ways.h"
#include "stepmill/access/lumps.h"

namespace stepmill {

class LumpSolver;

/// A lump as a small feature of its own. Whether it can be cleared is known from areas alone; which
/// surrogates do it in which way takes tool paths, and these are made when they are first asked for. May be
/// shared between threads.
class SolvedLump {
  public:
    explicit SolvedLump(std::unique_ptr<LumpSolver> solver);
    ~SolvedLump();

    /// Can some tool, or a few together, clear all of it?
    bool servable() const;
    /// What stays of a lump that is not servable after the few tools that together reach most of it.
    const Region& unserved() const;
    double area_mm2() const;
    const ToolAssembly& tool(int surrogate) const;
    /// The ways to clear it, with the weights of real paths. Of a lump that is not servable: none.
    const std::vector<LumpWay>& ways() const;
    /// Lengths and times of the paths of ways()[way], in the order of its tools.
    const std::vector<PathTotals>& totals(int way) const;
    /// The step of the tool that comes in that place of ways()[way], proved.
    /// \throws Error(Internal) if its path gouges
    SequenceStep step(int way, std::size_t place) const;

  private:
    const LumpSolver& weighed() const;

    std::unique_ptr<LumpSolver> solver_;
    mutable std::once_flag weighed_;
};

using Lumps = std::vector<std::shared_ptr<const SolvedLump>>;

/// Finds the lumps of each edge and the surrogates that clear them. Keeps what it has found; safe to share
/// between threads.
class SurrogateFinder {
  public:
    /// \param reaches  with their surrogates [withSurrogates()]; tools that take part may stand in for others
    SurrogateFinder(std::shared_ptr<const SequenceJob> job, const std::vector<ToolReach>& reaches);
    ~SurrogateFinder();

    /// The lumps of edge (m, n), each a small feature of its own: what of n's lumps m (null: nothing yet) has
    /// not cleared. Empty when n has none or nothing is left of them.
    Lumps lumpsOf(const CutterArea* m, const ToolReach& n) const;
    /// A tool's number among the surrogates; kNoTool when it is none.
    /// \pre a tool of the job's library
    int numberOf(const ToolAssembly& tool) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace stepmill
