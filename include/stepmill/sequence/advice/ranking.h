#pragma once

#include <optional>
#include <vector>

#include "stepmill/catalog/access_table.h"
#include "stepmill/catalog/machine.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/feature/feature.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {

/// A line of the ranking table [Lim2000, Fig. 8].
struct RankedRow {
    AccessRow cutter;
    double time_min = 0;  ///< volume / removal rate
    double share = 0;     ///< of the most any cutter of the table reaches
    /// Rank 0 finishes; rank k is used before rank k - 1. Nothing for cutters the ranking leaves out.
    std::optional<int> rank;
    /// Eq. 1: time with this cutter before the ranks narrower than it. Nothing for
    /// cutters no wider than rank 0, that reach nothing, or that reach more than the rank before.
    std::optional<double> dvcd_min;
    /// Time with all ranks up to this diameter, as the paper prints it: without tool changes, and with one
    /// for every rank but the first tool used.
    double rdvc_min = 0;
    double rdvc_with_changes_min = 0;
};

/// Tools in the order of use and what they need, the first tool's change not counted.
struct RankedSet {
    std::vector<int> rows;  ///< indices into Ranking::rows, falling diameter
    double total_min = 0;
};

struct Ranking {
    double tool_change_s = 0;
    std::vector<RankedRow> rows;  ///< by rising diameter; of equal ones the one that reaches less last
    RankedSet greedy;
    RankedSet shortest_path;
};

/// What a drill does in the holes of some features. Drills are no rows of the ranking: each reaches only
/// holes of its own width, so none goes before another.
struct DrillRow {
    std::string tool;
    double diameter_mm = 0;
    int makes = 0;          ///< holes that it makes by itself
    int makes_room_in = 0;  ///< holes that it drills for a mill
    double volume_cm3 = 0;  ///< that it takes in all of them
    double time_min = 0;    ///< on real paths, without tool changes
};

/// The drills of a library that have data for the material, in its order; those that fit no hole have zeros.
std::vector<DrillRow> drillTable(const std::vector<Feature>& features, const ToolLibrary& library,
                                 const Machine& machine, const SequenceOptions& options,
                                 const Tolerances& tol);

/// The ranking of [Lim2000] and the cheapest sequence over the same table.
///
/// Rank 0 is the largest cutter with full access (kFullAccessShare); each further rank the wider cutter that
/// makes eq. 1 least, as long as that falls; changes do not count in it. `greedy` takes as many ranks as pay
/// with tool changes, as section 5 of the paper does. `shortest_path` is the optimum over all sequences in
/// falling diameter, so never worse. Both assume, as the paper does, that a wider cutter reaches part of what
/// a narrower one does: of cutters that reach more than a narrower one, the sequences take no step to that.
/// Both sets are empty when no cutter reaches anything. O(n^2).
/// \pre diameters and removal rates above 0, tool_change_s >= 0
Ranking rankTools(std::vector<AccessRow> table, double tool_change_s);

/// The table of these features for the cutters of a library that leave a flat floor and have data for the
/// material, in the library's order. Volumes are coverable area x depth, summed over the features, as in the
/// paper those of the cutter alone; `clear_volume_cm3` tells what of that its reach, shank and holder allow:
/// none where `options.clear_of_own_material` turns the tool down. Removal rate is step-over x step-down x
/// feed, within what the machine can do.
std::vector<AccessRow> accessTable(const std::vector<Feature>& features, const ToolLibrary& library,
                                   const Machine& machine, const SequenceOptions& options,
                                   const Tolerances& tol);

/// A feature whose tools were looked at before.
struct ReachedFeature {
    double depth_mm = 0;
    const std::vector<ToolReach>* tools = nullptr;  ///< as ToolSequence::tools
};

/// The same table from what a plan has looked at, which costs nothing more.
std::vector<AccessRow> accessTable(const std::vector<ReachedFeature>& features, const ToolLibrary& library,
                                   const Machine& machine, const std::string& material);

}  // namespace stepmill
