#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "sequence/dag/candidate.h"
#include "sequence/dag/evaluate_dag.h"
#include "sequence/surrogates/lump_ways.h"
#include "stepmill/access/lumps.h"

namespace stepmill {

/// What the tools that their holder keeps off part of a feature may do, whatever is given up.
struct HeldOffTools {
    std::vector<std::shared_ptr<const AccessibleArea>> own;  ///< of each area; null: nothing, or no holder
    std::vector<Region> held_off;                            ///< of each area: what its cutter alone reaches
    std::vector<const AccessibleArea*> reach;  ///< all tools' areas free of collisions, by falling diameter
    Region out_of_reach;                       ///< held off and reached by no tool
};

/// \param areas  as the cutters and holders have them; must outlive the result
HeldOffTools heldOffTools(const FeatureGround& ground, const ToolLibrary& library,
                          const std::vector<AccessibleArea>& areas);

/// Lets tools whose shank or holder is in the way somewhere take part with all that their cutter reaches, as
/// far as some tool of `areas` reaches it: fills in what they may do themselves and the lumps that others
/// must do. One that no other tool can help is limited to what it reaches.
/// \param held_off  heldOffTools() of these areas
/// \param given_up  ground that nobody is asked for, though some tool reaches it
void admitWithSurrogates(const FeatureGround& ground, const HeldOffTools& held_off, const Region& given_up,
                         std::vector<AccessibleArea>& areas);

/// What the tool itself reaches; null when that is nothing.
const AccessibleArea* ownReach(const AccessibleArea& area);

class LumpSolver;

/// A lump as a small feature of its own. Whether it can be cleared is known from areas alone; who does it in
/// which way takes tool paths, and these are made when they are first asked for. May be shared between
/// threads.
class SolvedLump {
  public:
    explicit SolvedLump(std::unique_ptr<LumpSolver> solver);
    ~SolvedLump();

    /// Can some tool, or a few together, clear all of it?
    bool servable() const;
    /// What stays of a lump that is not servable after the few tools that together reach most of it.
    const Region& unserved() const;
    double area_mm2() const;
    const ToolAssembly& tool(int helper) const;
    /// The ways to clear it, with the weights of real paths. Of a lump that is not servable: none.
    const std::vector<LumpWay>& ways() const;
    /// Lengths and times of the paths of ways()[way], in the order of its tools.
    const std::vector<PathTotals>& totals(int way) const;
    /// The step of the tool that comes in that place of ways()[way], proved. \throws Error(Internal) if its
    /// path gouges
    SequenceStep step(int way, std::size_t place) const;

  private:
    const LumpSolver& weighed() const;

    std::unique_ptr<LumpSolver> solver_;
    mutable std::once_flag weighed_;
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
