#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "report/page/element.h"
#include "report/page/measures.h"
#include "stepmill/plan/plan.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill::report {

/// Edges of a tool DAG as (from, to); empty for source and sink.
using DagWay = std::set<std::pair<DagNode, DagNode>>;

/// The best of the other ways over the edges that were weighed.
struct RunnerUp {
    std::vector<DagNode> nodes;
    double more = 0;  ///< than the cheapest way by itself; seconds or money, as the plan's objective asks
};

/// The way along nodes, its edge to the sink with it; empty without any.
DagWay wayAlong(const std::vector<DagNode>& nodes);

/// What a drawing of a tool DAG shows beside its edges.
struct DagWays {
    DagWay chosen;
    std::optional<RunnerUp> runner_up;  ///< nothing where there is no other way
    /// Where the part as a whole took another way than is cheapest for the feature by itself: that one.
    std::vector<DagNode> own_cheapest;
};

/// \note  A shortest path for every edge of the cheapest one.
DagWays waysOf(const Plan& plan, const ToolSequence& sequence);

/// The tool DAG of a feature: source, tools by falling diameter (one that may work alone twice) and sink in a
/// row, an arc for every edge that was evaluated; the way that was chosen thick, with area, time and money,
/// the runner-up dashed. Nothing where there is no choice.
std::optional<Element> dagDrawing(const Plan& plan, const ToolSequence& sequence, const Measures& in);

}  // namespace stepmill::report
