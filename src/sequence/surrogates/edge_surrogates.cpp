#include "sequence/surrogates/edge_surrogates.h"

#include <algorithm>

#include "sequence/surrogates/surrogates.h"

namespace stepmill {
namespace {

/// One visit of a surrogate to a lump.
struct Visit {
    std::size_t lump = 0;
    int way = 0;
    std::size_t place = 0;  ///< in the way
    int surrogate = 0;
};

/// All visits in machining order. Every way has its tools by rising number, so all can be merged so; the tool
/// that follows may come last where it is the last of its ways.
std::vector<Visit> visitsOf(const EdgeSurrogates& surrogates, const ChosenWays& choice, int last) {
    std::vector<Visit> visits;
    for (std::size_t i = 0; i < surrogates.lumps.size(); ++i) {
        const LumpWay& way = surrogates.lumps[i]->ways()[choice.ways[i]];
        for (std::size_t k = 0; k < way.tools.size(); ++k)
            visits.push_back({i, choice.ways[i], k, way.tools[k]});
    }
    std::stable_sort(visits.begin(), visits.end(), [&](const Visit& a, const Visit& b) {
        const bool a_last = a.surrogate == last;
        const bool b_last = b.surrogate == last;
        return a_last != b_last ? b_last : a.surrogate < b.surrogate;
    });
    return visits;
}

}  // namespace

const ChosenWays& EdgeSurrogates::choice(int next) const {
    const auto found = before.find(next);
    return found == before.end() ? plain : found->second;
}

double EdgeSurrogates::saving(int next) const {
    return lumps.empty() ? 0 : plain.weight - choice(next).weight;
}

double EdgeSurrogates::largestSaving() const {
    double largest = 0;
    for (const auto& [next, choice] : before)
        largest = std::max(largest, plain.weight - choice.weight);
    return largest;
}

EdgeSurrogates surrogatesOfEdge(const SurrogateFinder& finder, const std::vector<Candidate>& tools,
                                const Candidate* m, int n, double change_weight) {
    EdgeSurrogates surrogates;
    surrogates.lumps = finder.lumpsOf(m != nullptr ? m->cleared : nullptr, *tools[n].reach);
    std::vector<std::vector<LumpWay>> ways;
    for (const auto& lump : surrogates.lumps)
        ways.push_back(lump->ways());
    surrogates.plain = cheapestWays(ways, change_weight);
    if (!surrogates.possible() || surrogates.lumps.empty()) return surrogates;
    for (int next = n + 1; next < static_cast<int>(tools.size()); ++next) {
        const int surrogate = finder.numberOf(*tools[next].tool);
        if (surrogate == kNoTool) continue;
        ChosenWays choice = cheapestWays(ways, change_weight, surrogate);
        if (choice.joins_next) surrogates.before.emplace(next, std::move(choice));
    }
    return surrogates;
}

void addSurrogates(const EdgeSurrogates& surrogates, int next, const Machine& machine, DagEdge& edge) {
    if (surrogates.lumps.empty()) return;
    const ChosenWays& choice = surrogates.choice(next);
    int last_surrogate = kNoTool;
    for (const Visit& visit : visitsOf(surrogates, choice, kNoTool)) {
        const SolvedLump& lump = *surrogates.lumps[visit.lump];
        const ToolAssembly& tool = lump.tool(visit.surrogate);
        const PathTotals& totals = lump.totals(visit.way)[visit.place];
        if (visit.surrogate != last_surrogate) edge.surrogates.push_back({tool.id, 0, {}});
        const EdgeCost change = edgeCost({}, tool, machine);
        const EdgeCost visit_cost = edgeCost(totals, tool, machine);
        const bool pays_change = visit.surrogate != last_surrogate;
        edge.time_s += visit_cost.time_s - (pays_change ? 0 : change.time_s);
        edge.cost += visit_cost.cost - (pays_change ? 0 : change.cost);
        edge.motion_s += visit_cost.motion_s - (pays_change ? 0 : change.motion_s);
        edge.surrogates.back().area_mm2 += lump.area_mm2();
        edge.surrogates.back().totals += totals;
        last_surrogate = visit.surrogate;
    }
    if (!choice.joins_next) return;
    // The tool that follows is the last of them, and its change counts on its own edge.
    const EdgeCost change = edgeCost(
        {},
        surrogates.lumps.front()->tool(surrogates.lumps.front()->ways()[choice.ways.front()].tools.front()),
        machine);
    edge.time_s -= change.time_s;
    edge.cost -= change.cost;
    edge.motion_s -= change.motion_s;
}

std::vector<const ToolAssembly*> surrogatesBefore(const EdgeSurrogates& surrogates, int next,
                                                  const SurrogateFinder& finder,
                                                  const std::vector<Candidate>& tools) {
    std::vector<const ToolAssembly*> in_order;
    if (surrogates.lumps.empty()) return in_order;
    const ChosenWays& choice = surrogates.choice(next);
    const int last = choice.joins_next ? finder.numberOf(*tools[next].tool) : kNoTool;
    for (const Visit& visit : visitsOf(surrogates, choice, last)) {
        const ToolAssembly* tool = &surrogates.lumps[visit.lump]->tool(visit.surrogate);
        if (in_order.empty() || in_order.back() != tool) in_order.push_back(tool);
    }
    return in_order;
}

std::vector<SequenceStep> surrogateSteps(const EdgeSurrogates& surrogates, int next,
                                         const SurrogateFinder& finder, const std::vector<Candidate>& tools) {
    std::vector<SequenceStep> steps;
    if (surrogates.lumps.empty()) return steps;
    const ChosenWays& choice = surrogates.choice(next);
    const int last = choice.joins_next ? finder.numberOf(*tools[next].tool) : kNoTool;
    for (const Visit& visit : visitsOf(surrogates, choice, last)) {
        steps.push_back(surrogates.lumps[visit.lump]->step(visit.way, visit.place));
        steps.back().role = Role::Surrogate;
    }
    return steps;
}

}  // namespace stepmill
