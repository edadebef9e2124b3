#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/catalog/tool.h"
#include "stepmill/sequence/sequence.h"
#include "stepmill/toolpath/cut_feeds.h"
#include "stepmill/toolpath/toolpath.h"

namespace stepmill {

/// What the library says a tool's cuts in the material may be: feeds follow from it and from what is cut.
struct CutRating {
    double step_over_mm = 0;  ///< the width that feed and rated removal are for
    double step_down_mm = 0;  ///< the depth that they are for
    double slot_step_down_mm = 0;
    double removal_mm3_per_min = 0;
};

/// What a plan, its plan.json and a program all say of one visit of one tool to one feature.
struct OperationData {
    std::string id;  ///< "S1.O3", numbered in machining order
    std::string setup_id;
    std::string feature_id;  ///< of a form operation: of the setup's FormGround
    Role role = Role::Rough;
    double z_floor_mm = 0;   ///< of this operation: with an allowance on the floor, as much over it
    FinishAllowance leaves;  ///< for a finishing operation of the same feature
    double speed_rpm = 0;
    Coolant coolant = Coolant::Flood;
    double dwell_s = 0;  ///< at the bottom of each drilled hole; counted in totals, not in the path
    int holes = 0;       ///< that an operation with a tool for holes works on, a countersink too; else 0
    std::optional<ThreadCut> thread;  ///< of a tapping operation
    std::optional<Fit> fit;           ///< of a reaming or boring operation: what the bore gets
    double ramp_angle_deg = 0;        ///< steepest descent through material that is no plunge; 0: not told
    /// Of an adaptive operation: no cut at depth engages more of the cutter's rim [deg]; 0: there is no
    /// limit.
    double engagement_deg = 0;
    /// Of a form operation: what it takes of the volumes that leaning walls hide from flat layers; of a
    /// drilling one what its points take below the floor.
    std::vector<ReasonVolume> takes;
    /// Of an operation that breaks edges: what goes of the part; no part of stock minus part.
    double breaks_mm3 = 0;
    /// Nothing: its feeds are the library's, whatever is cut.
    std::optional<CutRating> rating;
    /// How hard it is driven to keep a cycle time: 1 as its cutting data say; below, speed and feeds are as
    /// many times lower; above, cuts that have a rating are fed higher (CuttingFacts::pace).
    double pace = 1;

    double dwellOfAll_s() const { return dwell_s * std::max(1, holes); }
};

/// How many operations of another feature, from its first on, must be done before.
struct Wait {
    std::string feature_id;
    int operations = 0;
};

/// A planned one, with its path.
struct Operation : OperationData {
    std::string tool_id;
    Toolpath path;
    PathProof proof;
    double z_top_mm = 0;
    /// Area cleared / step-over x depths: how long the path would be if all its passes lay evenly side by
    /// side and nothing else had to be cut; 0 for drills [mm].
    double even_length_mm = 0;
    CutSummary cuts;  ///< where it has a rating
    /// Of the path's moves, for pictures; empty: not known.
    std::vector<MoveLoad> loads;
    /// How far the features above must be cut before it may run; empty: its feature's parents wholly.
    std::vector<Wait> waits;

    /// Its times, dwell included, without the tool change [s]: of feeds alone, of all moves at the programmed
    /// speeds, and as the machine's acceleration makes them.
    double feedS() const { return path.totals.feed_time_s + dwellOfAll_s(); }
    double timeS() const { return path.totals.time_s() + dwellOfAll_s(); }
    double motionS() const { return path.totals.motion_time_s + dwellOfAll_s(); }
};

/// The lowest place of the tool's tip [mm].
double lowestMm(const Operation& operation);

/// One as it is told without its moves: with its tool, and of its path what it was made by.
struct OperationSheet : OperationData {
    ToolAssembly tool;  ///< from plan.json without cutting data
    std::string pattern;
    int depths = 1;  ///< "layers" in plan.json
    double step_down_mm = 0;
    double feed_mm_per_min = 0;
    double plunge_feed_mm_per_min = 0;
};
/// How fast the operation's cuts may go and what they ask for; nothing where it has no rating, or the machine
/// no spindle.
/// \param material  that is cut
std::optional<CuttingModel> cuttingModelOf(const OperationSheet& operation, const Material& material,
                                           const Machine& machine);

OperationSheet sheetOf(const Operation& operation, const ToolLibrary& library);

}  // namespace stepmill
