#pragma once

#include <memory>
#include <vector>

#include "sequence/candidate.h"
#include "sequence/evaluate_dag.h"
#include "sequence/lump_ways.h"
#include "stepmill/access/lumps.h"

namespace stepmill {

/// Lets tools whose shank or holder is in the way somewhere take part with all that their cutter reaches, as
/// far as some tool of `areas` reaches it: fills in what they may do themselves and the lumps that others
/// must do. One that no other tool can help is limited to what it reaches.
/// \param given_up  ground that nobody is asked for, though some tool reaches it
void admitWithSurrogates(const FeatureGround& ground, const ToolLibrary& library, const Region& given_up,
                         std::vector<AccessibleArea>& areas);

/// What the tool itself reaches; null when that is nothing.
const AccessibleArea* ownReach(const AccessibleArea& area);

/// A lump as a small feature of its own, with the ways to clear it. No way: no tool can, nor can a few
/// together.
class SolvedLump {
  public:
    const std::vector<LumpWay>& ways() const { return ways_; }
    /// What stays of a lump without ways after the few tools that together reach most of it.
    const Region& unserved() const { return unserved_; }
    double area_mm2() const { return ground_.feature().area_mm2; }
    const ToolAssembly& tool(int helper) const { return *tools_[numberOf(helper)].tool; }
    /// Lengths and times of the paths of ways()[way], in the order of its tools.
    const std::vector<PathTotals>& totals(int way) const { return totals_[way]; }
    /// The step of the tool that comes in that place of ways()[way], proved. \throws Error(Internal) if its
    /// path gouges
    SequenceStep step(int way, std::size_t place) const;

  private:
    friend class LumpSolver;
    explicit SolvedLump(FeatureGround ground) : ground_(std::move(ground)) {}
    DagTask task() const { return {ground_, tools_, ends_, *options_, *machine_, retract_z_mm_}; }
    std::size_t numberOf(int helper) const;

    FeatureGround ground_;
    std::vector<AccessibleArea> areas_;
    std::vector<Candidate> tools_;  ///< point into areas_
    std::vector<int> helpers_;      ///< number of each of tools_ among the finder's
    std::vector<bool> ends_;        ///< which of tools_ clear the whole lump
    std::vector<SharedRings> rings_;
    std::vector<LumpWay> ways_;
    Region unserved_;
    std::vector<std::vector<PathTotals>> totals_;
    const SequenceOptions* options_ = nullptr;
    const Machine* machine_ = nullptr;
    double retract_z_mm_ = 0;
};

using Lumps = std::vector<std::shared_ptr<const SolvedLump>>;

/// Finds who clears the lumps of each edge. Immutable but for what it keeps; lumpsOf() may be asked from
/// several threads.
class SurrogateFinder {
  public:
    /// Keeps all it is given. `areas` after admitWithSurrogates().
    SurrogateFinder(const FeatureGround& ground, const std::vector<AccessibleArea>& areas,
                    const ToolLibrary& library, const SequenceOptions& options, const Machine& machine,
                    double retract_z_mm);
    ~SurrogateFinder();

    /// The lumps of edge (m, n), each a small feature of its own: what of n's lumps m (null: nothing yet) has
    /// not cleared. Empty when nothing is left of them.
    Lumps lumpsOf(const AccessibleArea* m, const AccessibleArea& n) const;
    /// A tool's number among those that can help; kNoTool when it cannot.
    int numberOf(const ToolAssembly& tool) const;

  private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace stepmill
