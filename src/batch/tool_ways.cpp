#include "batch/tool_ways.h"

#include <algorithm>
#include <map>
#include <set>

namespace stepmill::batch {
namespace {

using Ways = std::vector<ToolWay>;

/// Ways that are kept from any tool on.
constexpr std::size_t kMostWays = 24;

/// The tool the edge goes to and its surrogates, with those of the way that goes on from there.
ToolWay along(const DagEdge& edge, const ToolWay& onwards, Objective objective) {
    std::set<std::string> tools(onwards.tools.begin(), onwards.tools.end());
    if (!edge.to.empty()) tools.insert(edge.to.tool);
    for (const SurrogateWork& surrogate : edge.surrogates)
        tools.insert(surrogate.tool);
    return {{tools.begin(), tools.end()},
            onwards.cost + (objective == Objective::Time ? edge.time_s : edge.cost)};
}

/// Takes at most as many tools, all of the other's.
bool needsNoMore(const ToolWay& one, const ToolWay& other) {
    return std::includes(other.tools.begin(), other.tools.end(), one.tools.begin(), one.tools.end());
}

Ways best(Ways all) {
    std::stable_sort(all.begin(), all.end(),
                     [](const ToolWay& a, const ToolWay& b) { return a.cost < b.cost; });
    Ways kept;
    for (ToolWay& way : all) {
        const bool beaten = std::any_of(kept.begin(), kept.end(),
                                        [&](const ToolWay& cheaper) { return needsNoMore(cheaper, way); });
        if (!beaten && kept.size() < kMostWays) kept.push_back(std::move(way));
    }
    return kept;
}

/// From every node to the end, each worked out once.
class WaysToEnd {
  public:
    WaysToEnd(const std::vector<DagEdge>& edges, Objective objective) : objective_(objective) {
        for (const DagEdge& edge : edges)
            edges_[edge.from].push_back(&edge);
    }

    const Ways& from(const DagNode& node) {
        const auto known = ways_.find(node);
        if (known != ways_.end()) return known->second;
        Ways all;
        for (const DagEdge* edge : edges_[node]) {
            const Ways& onwards = edge->to.empty() ? end_ : from(edge->to);
            for (const ToolWay& way : onwards)
                all.push_back(along(*edge, way, objective_));
        }
        return ways_[node] = best(std::move(all));
    }

  private:
    Objective objective_;
    Ways end_{{{}, 0}};
    std::map<DagNode, std::vector<const DagEdge*>> edges_;
    std::map<DagNode, Ways> ways_;
};

}  // namespace

std::vector<ToolWay> waysThrough(const std::vector<DagEdge>& edges, Objective objective) {
    return WaysToEnd(edges, objective).from({});
}

}  // namespace stepmill::batch
