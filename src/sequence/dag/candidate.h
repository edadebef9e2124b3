#pragma once

#include <vector>

#include "sequence/dag/wall_lengths.h"
#include "stepmill/access/access.h"
#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// A node of a feature's tool DAG: a tool that can machine something there, with its cutting data held to
/// what the machine can do. Points into the library and the reaches it was made from, which stay in place
/// with the job and the choices that hold the DAG.
struct Candidate {
    const ToolAssembly* tool = nullptr;
    const ToolReach* reach = nullptr;
    const CutterArea* cleared = nullptr;  ///< when the tool and its surrogates are done
    const CutterArea* own = nullptr;      ///< where the tool itself goes
    CuttingData cutting;
    double coverable_mm2 = 0;          ///< of the target; a matching drill's is the whole target
    double volume_rate_mm3_per_s = 0;  ///< no move of this tool removes more per second
    double rate_as_cut_mm3_per_s = 0;  ///< the same at feeds by what is cut, where they are
    WallLength walls;                  ///< that a mill touches by itself
    double wall_rate_mm_per_s = 0;     ///< no more wall is gone along in a second, over the whole depth
    /// No move of this tool or, where it has surrogates, of any of them removes more per second.
    double joint_rate_mm3_per_s = 0;
    /// The same of its surrogates that are no candidates themselves; 0 without surrogates.
    double outsider_rate_mm3_per_s = 0;
    double outsider_rate_as_cut_mm3_per_s = 0;  ///< at feeds by what is cut
    /// A drill that makes room for the mill after it: it comes before all mills and ends nothing.
    bool predrills = false;
    /// The tool does what its holder allows, and what that keeps it off is left to later tools though others
    /// could stand in for it at once.
    bool alone = false;
    /// A spot drill that starts the hole for the drill after it: it comes first and clears nothing.
    bool spots = false;

    DagNode node() const { return {tool->id, alone}; }
    bool drill() const { return tool->isDrill(); }
    /// Does it start true only where a spot is?
    bool wantsSpot() const { return drill() && !tool->self_centring; }
    /// Does it clear ground, as drills and spot drills do not?
    bool mills() const { return !drill() && !spots; }
    bool hasSurrogates() const { return !alone && reach->surrogates() != nullptr; }
    /// Does it leave what others reach before it or after it?
    bool isLimited() const { return alone || reach->limited() != nullptr; }
};

/// What that time on the machine costs, without wear and tool changes.
EdgeCost machineCost(double seconds, const Machine& machine);

/// Upper bound of the material one tool can remove per second [costs.md, 'The lower bound'].
///
/// Along a way that falls by t a cutter sweeps d a cos t + (pi d^2 / 4) sin t per length, d wide and a deep,
/// at the feed of that slope (rampFeed). It goes down no steeper than it ramps, but where it may plunge. A
/// drill only descends.
double volumeRate(const Feature& feature, const ToolAssembly& tool, const CuttingData& cutting);

/// Least seconds that `to` takes along the walls that it is the first to touch. 0 where that is not known:
/// where surrogates of either touch walls too.
/// \param from  null: nothing is cut before
double leastWallS(const Candidate* from, const Candidate& to);

/// Tools by falling diameter, ties by rising stick-out, then in the library's order [tool-dag.md,
/// 'Nodes and edges'].
std::vector<const ToolAssembly*> byFallingDiameter(const ToolLibrary& library);

/// The tools of `reaches` that can machine something of the feature, in their order, but spot drills first
/// and after them the drill that makes room for mills. A tool with surrogates comes twice: alone, where
/// the rule for surrogates has that, then with them. They point into `reaches` and `library`.
/// \pre `reaches` are in the order of byFallingDiameter()
std::vector<Candidate> usableTools(const Feature& feature, const std::vector<ToolReach>& reaches,
                                   const ToolLibrary& library, const SequenceOptions& options,
                                   const Machine& machine, const Tolerances& tol);

/// Which candidates clear all that any of them can: the nodes with an edge to the sink.
std::vector<bool> endTools(const Feature& feature, const std::vector<Candidate>& tools,
                           const Tolerances& tol);

/// Areas of one feature that differ by less are the same to the DAG: full access [Lim2000] within 1e-5.
double sameArea(const Feature& feature, const Tolerances& tol);

}  // namespace stepmill
