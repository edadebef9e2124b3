#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "stepmill/catalog/fixture.h"
#include "stepmill/catalog/hole_table.h"
#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/material.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/feature/feature.h"
#include "stepmill/feature/form_ground.h"
#include "stepmill/part/part.h"
#include "stepmill/plan/assignment.h"
#include "stepmill/plan/cycle_time.h"
#include "stepmill/plan/earlier_plan.h"
#include "stepmill/plan/operation.h"
#include "stepmill/plan/operation_order.h"
#include "stepmill/plan/patience.h"
#include "stepmill/sequence/sequence.h"
#include "stepmill/setup/clamping.h"
#include "stepmill/setup/setup.h"

namespace stepmill {

/// Something the reader of a plan must know. Codes are stable words for programs.
struct Warning {
    std::string code;     ///< "unit-doubt", "input-doubt", "not-2.5d", "residual", "no-tool", ...
    std::string subject;  ///< "S1.F2", "part.step"; of several causes alike the first
    std::string text;
    int count = 1;  ///< how many causes alike it stands for
};

struct PlannedFeature {
    Feature feature;
    ToolSequence sequence;  ///< its steps' paths have moved to the operations
};

struct PlanTotals {
    double time_s = 0;
    double motion_s = 0;   ///< `time_s` with the machine's acceleration where that is given
    double cutting_s = 0;  ///< all feed moves
    double air_s = 0;      ///< rapids
    double tool_change_s = 0;
    int tool_changes = 0;
    double cost = 0;
    double lower_bound_s = 0;  ///< no sequences of these tools over these features take less [costs.md]
};

/// Solids' volumes are sums over their faces; a difference below this is rounding, nothing to machine [mm3].
inline constexpr double kVolumeRoundingMm3 = 1e-2;

/// The books of a setup or of the part: stock minus part, and where each part of it went.
///
/// Of a setup: its stock as it arrives; unreachable is what its features do not own, for other setups to
/// reach. Of the part: the raw stock; residual and unreachable are what is still there after the last setup.
struct VolumeBalance {
    double stock_minus_part_mm3 = 0;
    double planned_mm3 = 0;
    double residual_mm3 = 0;
    double unreachable_mm3 = 0;
    std::vector<ReasonVolume> residual_by_reason;     ///< in the order of the reasons' names
    std::vector<ReasonVolume> unreachable_by_reason;  ///< the same

    /// Of all that is to be removed.
    double leftMm3() const { return residual_mm3 + unreachable_mm3; }
    /// What no entry accounts for; negative where entries account for more than there is.
    double gapMm3() const;
    /// The same without its sign, as a share of stock minus part; 0 where that is no more than rounding.
    double gapShare() const;
};

/// Do the books of a setup close, to rounding and to the share of the part's stock minus part that tolerances
/// allow?
bool closes(const VolumeBalance& setup, double stock_minus_part_mm3, const Tolerances& tol);

/// What came of choosing the features' sequences together.
struct ToolSharing {
    int features_changed = 0;  ///< that took another sequence than their own cheapest
    int visits_alone = 0;      ///< tool changes with each feature's own cheapest, operations merged
    int visits = 0;            ///< tool changes as planned
    double saved = 0;          ///< seconds or money, as the objective asks; never negative where tools fit
    int tools_alone = 0;       ///< different tools, in the same way
    int tools = 0;
};

struct PlannedSetup {
    Setup setup;
    Clamping clamping;
    std::vector<PlannedFeature> features;  ///< parents before children
    FeatureNames names;                    ///< that they keep from an earlier plan
    std::vector<Unplanned> unplanned;
    std::vector<Prism> reserve;         ///< stands for later setups, which cut it; in setup coordinates
    std::vector<Operation> operations;  ///< in machining order
    std::vector<WeighedOrder> orders;   ///< that were weighed for these, the one taken first
    /// Where its form operations work, which come after all others; nothing without any.
    std::optional<FormGround> form;
    /// What leaning walls keep from flat cutters at most, where form cutters were weighed for it [mm3].
    std::optional<double> leaning_mm3;
    /// Where its edges are broken, after all others; nothing where that is not asked for or none is.
    std::optional<FormGround> edges;
    VolumeBalance balance;
    double time_s = 0;    ///< tool changes included
    double motion_s = 0;  ///< the same with the machine's acceleration where that is given
};

/// How a feature is planned after a plan whose programs were not proven in it. Later fields are safer.
struct FeatureCaution {
    std::string why;            ///< what the proof said first, and where
    bool not_adaptive = false;  ///< any pattern but that of constant engagement
    bool plain_ways = false;    ///< one pattern of rings, and rapids as withPlainRapids() makes them
    std::set<std::string> without_tools;  ///< ids
    std::vector<Residual> left;  ///< what its tools were found to leave: it stays, and what lies below it
    bool dropped = false;        ///< no tool touches it
};

/// By feature id.
using Cautions = std::map<std::string, FeatureCaution>;

inline constexpr double kLeastScallopMm = 0.002;
inline constexpr double kMostScallopMm = 0.5;
inline constexpr double kUsualScallopMm = 0.02;

inline constexpr double kLeastEdgeBreakMm = 0.05;
inline constexpr double kMostEdgeBreakMm = 2.0;

struct PlanRequest {
    std::string unit;  ///< ReadOptions::unit, by which the part was read
    SetupRequest setup;
    SliceOptions slicing;
    SequenceOptions sequence;
    int quantity = 1;  ///< pieces of the lot, among which setting up is shared
    /// Height of the ridges that form cutters leave between their passes [mm]; 0: no pass of theirs.
    double scallop_mm = 0;
    /// Sharp edges that look up are broken by so much [mm]; 0: they stay sharp.
    double break_edges_mm = 0;
    std::string materials_file;    ///< where sequence.cut_material was looked for; empty: nowhere
    FixtureFile fixtures;          ///< what holds the setups it names, and what the shop has for the others
    std::optional<HoldKind> hold;  ///< how those others are held; nothing: as suggestClamping() finds
    HoleTable holes;               ///< what is said of holes beyond the part's file; none: nothing
    /// Roughing alone, which leaves this on walls and floors; nothing: the plan makes size.
    std::optional<FinishAllowance> roughing;
    /// Which setup cuts what, where that is known from a plan before; nothing: it is found out. By
    /// `assign` false every setup cuts all it reaches.
    std::optional<Assignment> assignment;
    bool assign = true;
    bool common_ground = true;  ///< nested features may be cut down together where that is quicker
    Cautions cautions;          ///< none in the first plan of a part
    Patience patience;
    /// A plan that this one is made after: what is still there keeps ids and order; empty: none.
    std::vector<EarlierSetup> earlier;
    /// Taken over from that plan where sight asks for the same setups and no more stays; nothing: found out
    /// anew.
    std::optional<EarlierAssignment> as_before;
    /// That are to be kept; of the part, a setup or a feature one at most.
    std::vector<CycleTarget> cycle_times;
    std::map<std::string, SequenceWish> wishes;  ///< by the id of a band, for the cycle times
};

struct Plan {
    PlanRequest request;
    Part part;
    Stock stock;
    Machine machine;
    ToolLibrary library;
    std::string material;
    Objective objective = Objective::Time;
    CostModel cost_model = CostModel::Path;
    std::vector<PlannedSetup> setups;
    Assignment assignment;
    ToolSharing sharing;
    PlanTotals totals;
    CycleTimes cycle;
    VolumeBalance balance;
    int threads_missing = 0;  ///< holes without the thread or the fit that the hole table asks for
    std::vector<Warning> warnings;

    /// Is every thread cut that was asked for, and all of stock - part machined, nothing left over but
    /// rounding? Of roughing: nothing but what it is meant to leave.
    bool complete(const Tolerances& tol) const;
};

class SequenceMemory;

/// Called at the start of each stage ("slicing S1", "S1.F2") with the share done in [0, 1].
using Progress = std::function<void(const std::string& stage, double share)>;

/// Plans one part: setups, layers, features, tool sequences, merged operations, totals and books.
///
/// Every setup is planned on the stock that the paths of those before it leave (plan/stages.h). A chosen
/// setup in which no tool finds anything new to do is left out. A feature whose planning fails becomes a
/// residual with a warning; the rest of the plan stands; so does one that the cautions drop ("proof"). Books
/// that do not close are a warning "books" that says where.
///
/// After an earlier plan of a part like it (`PlanRequest::as_before`) without the trials that chose its
/// setups and what each leaves, and where as much leans with the same form cutters: a third of the time.
///
/// \throws Error for input the plan cannot go on with (stock too small, a part many times larger than the
///         machine, no tool for the material).
Plan planPart(const Part& part, const PlanRequest& request, const ToolLibrary& library,
              const Machine& machine, const Tolerances& tol, const Progress& progress = {});

/// The same after other plans of the part with the same tools, machine and tolerances, in less time.
/// Operations are driven at the pace that keeps the request's cycle times; where the cutting data alone do
/// not, `Plan::cycle` says what they take.
/// \throws Error(Usage) for a cycle time of a setup or feature that the plan has not got
Plan planPart(const Part& part, const PlanRequest& request, const ToolLibrary& library,
              const Machine& machine, const Tolerances& tol, const Progress& progress,
              SequenceMemory& memory);

/// A plan, and the request that makes it again.
struct PlanOfRequest {
    Plan plan;
    PlanRequest request;
};

/// planPart(), and where the request's cycle times are still not kept at the fastest pace again with other
/// tools [Tripathi2005]: features that begin with a wider one, tools chosen by time where they were by money,
/// features that do without a tool. What makes the times shorter and leaves no more material is kept;
/// `Plan::cycle` tells of all that was tried. Costs a plan for each, of which the memory makes most.
PlanOfRequest planToTime(const Part& part, const PlanRequest& request, const ToolLibrary& library,
                         const Machine& machine, const Tolerances& tol, const Progress& progress,
                         SequenceMemory& memory);

}  // namespace stepmill
