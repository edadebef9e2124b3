#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/access/access.h"
#include "stepmill/catalog/fit.h"
#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/material.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/core/deadline.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/feature/feature.h"
#include "stepmill/sequence/advice/area_models.h"
#include "stepmill/sequence/least_times.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill {

/// What a choice makes least.
enum class Objective { Time, Cost };
std::string toString(Objective objective);
/// The reverse; nothing for another word.
std::optional<Objective> objectiveFrom(std::string_view word);

/// Who clears what a tool's holder keeps from it.
enum class SurrogateRule {
    Single,         ///< one tool per lump, at once [DSouza2006, Alg. 4]
    SingleOrLater,  ///< that, or tools that come later anyway
    Sequence        ///< one tool or several after another, at once or later, whichever is cheapest
};
std::string toString(SurrogateRule rule);
/// The reverse; nothing for another word.
std::optional<SurrogateRule> surrogateRuleFrom(std::string_view word);

/// Material that roughing leaves for a finishing pass to take off. Nothing: there is no such pass.
struct FinishAllowance {
    double walls_mm = 0;   ///< beside what must stay; open edges need none
    double floors_mm = 0;  ///< over the floor; what goes through has none

    bool any() const { return walls_mm > 0 || floors_mm > 0; }
    bool operator==(const FinishAllowance&) const = default;
};

/// Allowances a plan may ask for, apart from none [mm].
inline constexpr double kLeastAllowanceMm = 0.01;
inline constexpr double kMostAllowanceMm = 5;

struct SequenceOptions {
    std::string material;
    /// What its cuts ask for; nothing: not known, feeds are the library's whatever is cut.
    std::optional<Material> cut_material;
    Objective objective = Objective::Time;
    /// Rapids between entries go to this height over the stock's top [mm]; 0: the machine's safe height.
    double retract_mm = 0;
    SurrogateRule surrogates = SurrogateRule::Sequence;
    /// What the sequence is chosen by; its own paths are always real.
    CostModel cost_model = CostModel::Path;
    /// Turn down tools whose shank or holder would meet what they leave of the feature itself. [DSouza2006]
    /// looks at the stock right after the feature and does not; a plan must.
    bool clear_of_own_material = false;
    /// How the steps' regions are gone over.
    Pattern pattern = Pattern::Best;
    std::vector<Pattern> patterns;  ///< the best is chosen from these; empty: from all
    /// What the chosen sequence leaves on walls and floors, and then takes off in finishing steps. The choice
    /// itself is made without: finishing adds about the same to every sequence.
    FinishAllowance finish;
    /// The first mill is at least as wide, where any that can be used is [mm].
    double first_at_least_mm = 0;
    /// A choice that is not made by then ends with Error(TimedOut).
    Deadline deadline;
};

/// What a surrogate does on an edge of the tool DAG.
struct SurrogateWork {
    std::string tool;
    double area_mm2 = 0;  ///< of the lumps it works in
    PathTotals totals;    ///< of its paths there
};

/// A node of a feature's tool DAG; empty: the source or the sink.
struct DagNode {
    std::string tool;
    /// The tool does what its holder allows and leaves the rest to later tools, though others could stand in
    /// for it at once.
    bool alone = false;

    bool empty() const { return tool.empty(); }
    /// "EM25", "EM25 alone".
    std::string name() const { return alone ? tool + " alone" : tool; }
    friend auto operator<=>(const DagNode&, const DagNode&) = default;
};

/// One evaluated edge of the tool DAG: machine D_mn with n, and what n's holder keeps from it with
/// surrogates.
///
/// Time and cost hold n's path, the surrogates' paths and a change to each tool. On the path that is chosen a
/// surrogate that is the next tool anyway is changed to once, and the edge before it counts none.
///
/// Edges to the sink cost nothing and leave every tool that clears all any tool of the library can.
struct DagEdge {
    DagNode from;                ///< empty for the source
    DagNode to;                  ///< empty for the sink
    double region_area_mm2 = 0;  ///< n's own part, D'_mn
    PathTotals totals;           ///< of n's own path
    double time_s = 0;           ///< with the tool changes [DSouza2006, eq. 13]
    double cost = 0;             ///< with wear and the hourly rate [DSouza2006, eq. 12]
    double motion_s = 0;         ///< as `time_s`, with the machine's acceleration where that is given
    std::vector<SurrogateWork> surrogates;
};

/// Material of a feature that stays, and why.
struct Residual {
    Region region;
    double area_mm2 = 0;
    double volume_mm3 = 0;
    StayReason reason;
    std::string advice;  ///< what would machine it ("an end mill of 2.4 mm or less")
    /// What of it is still there on the finished part; nothing until all setups are planned [mm3].
    std::optional<double> stays_mm3;
    std::string taken_by;  ///< id of the later setup that takes the rest; empty: none does
};

enum class Role { Face, Rough, Rest, Surrogate, Spot, Drill, Ream, Bore, Tap, Finish, Form };
std::string toString(Role role);
/// The reverse; nothing for another word.
std::optional<Role> roleFrom(std::string_view word);

/// Does it clear ground in depths of cut: nothing that only holes have, no finishing pass, no form?
bool isClearing(Role role);
/// Does it bring bores to their fit?
bool isSizing(Role role);
/// Does it go straight down into holes?
bool isForHoles(Role role);

/// A thread that a step cuts into holes made before: with the spindle's turns, no volume of the part.
struct ThreadCut {
    Thread thread;
    double tip_z_mm = 0;      ///< the tap goes down to here, ...
    double full_to_z_mm = 0;  ///< ... and cuts the whole thread down to here
    std::vector<Vec2> places;
};

/// One tool's part in a feature.
struct SequenceStep {
    std::string tool_id;
    Role role = Role::Rough;
    DecomposedArea area;
    Toolpath path;
    PathProof proof;
    double speed_rpm = 0;
    /// How far the tool must be set out at least for this step; its only stick-out where it has no range.
    double least_stick_out_mm = 0;
    FinishAllowance leaves;           ///< what a finishing step after it takes off
    int holes = 0;                    ///< that a step of a tool for holes works on
    std::optional<Fit> fit;           ///< of a step that reams or bores
    std::optional<ThreadCut> thread;  ///< of a tapping step
    /// Of a drilling step: what its point takes below the floor, of volumes that belong to no feature.
    std::vector<ReasonVolume> takes;
};

/// A way through a feature's tool DAG.
struct SequenceChoice {
    std::vector<std::string> tools;  ///< visits in their order, surrogates among them; no tool twice in a row
    double paths = 0;                ///< seconds or money of the paths, without tool changes
};

/// The ways through the tool DAG of one feature that may be best beside other features, which call tools
/// anyway. All leave the same material as the feature's own optimum.
class SequenceChoices;

/// The cheapest sequence of tools for one feature, with all that was weighed.
struct ToolSequence {
    std::string feature_id;
    /// Depth the steps cut to: the feature's floor, or higher where no tool gets down to that.
    double floor_z_mm = 0;
    std::vector<ToolReach> tools;     ///< every tool of the library, falling diameter, with exclusions
    std::vector<DagEdge> edges;       ///< evaluated edges, by from then to
    std::vector<DagNode> way;         ///< the steps' way through the DAG, without source and sink
    std::vector<SequenceStep> steps;  ///< empty when no tool can machine anything
    /// What comes after the steps whichever way is chosen: bores brought to their fit. They become steps when
    /// tools are shared out.
    std::vector<SequenceStep> sizing;
    std::string not_sized;  ///< why holes do not get the fit they were to get; empty when they do
    double time_s = 0;      ///< with a tool change wherever the tool is another
    double cost = 0;
    double motion_s = 0;       ///< `time_s` with the machine's acceleration where that is given
    double lower_bound_s = 0;  ///< no plan with these tools can be faster [costs.md, 'The lower bound']
    /// The same at the feeds that plans run with, for sums over features that share tools: where feeds follow
    /// from what is cut, no move removes more than its tool is rated for, straight ways down apart.
    LeastTimes least;
    int pruned_edges = 0;  ///< DAG edges whose lower bound ruled them out unevaluated
    std::vector<Residual> residual;
    /// Why the steps leave less allowance than was asked for, in words; empty when they do not.
    std::string no_allowance;
    std::shared_ptr<const SequenceChoices> choices;  ///< null where there are no steps
};

/// The ways to choose from; the first is the sequence's own, and none of the others is worse than another in
/// every company. Empty where the sequence has no steps.
std::vector<SequenceChoice> choicesOf(const ToolSequence& sequence);

/// The sequence with its steps made anew along choicesOf(sequence)[index]; what sequenceTools() was given is
/// not needed any more.
/// \throws Error(Internal) if a path gouges
ToolSequence withChoice(const ToolSequence& sequence, std::size_t index);

/// Volume of all residuals of a feature [mm3].
double residualVolumeMm3(const ToolSequence& sequence);

/// Time and money of a path by one tool, its change included [DSouza2006, eq. 13 and 12].
struct EdgeCost {
    double time_s = 0;
    double cost = 0;
    /// The same with the machine's acceleration, where that is given: what tools are chosen by.
    double motion_s = 0;
    double motion_cost = 0;
};
EdgeCost edgeCost(const PathTotals& totals, const ToolAssembly& tool, const Machine& machine);

/// What a sequence makes least: seconds or money, with acceleration where the machine gives it.
double weightOf(const EdgeCost& cost, Objective objective);
/// Of a tool change.
double changeWeight(const Machine& machine, Objective objective);

/// The optimal tool sequence for a feature: areas of all tools, costs of all DAG edges on real paths
/// (evaluated in parallel), the cheapest path [tool-dag.md]. The result does not depend on the
/// number of threads. At most n(n+1)/2 edges are evaluated.
///
/// Tools whose holder only lets them do part of the feature take part with surrogates for the lumps they are
/// kept off [tool-dag.md, 'Surrogates']; one whose lumps no other can serve takes part with what it reaches
/// itself where that is more than all others reach. Where going less deep machines more than that, the steps
/// end at the depth the best tool reaches, and what is below is residual ("too deep").
/// \throws Error(TimedOut) soon after `options.deadline`, between two tools or edges
ToolSequence sequenceTools(const Feature& feature, const ToolLibrary& library, const Machine& machine,
                           const SequenceOptions& options, const Tolerances& tol);

}  // namespace stepmill
