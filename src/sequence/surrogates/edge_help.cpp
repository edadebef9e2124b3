#include "sequence/surrogates/edge_help.h"

#include <algorithm>

#include "sequence/surrogates/surrogates.h"

namespace stepmill {
namespace {

/// One visit of a surrogate to a lump.
struct Visit {
    std::size_t lump = 0;
    int way = 0;
    std::size_t place = 0;  ///< in the way
    int helper = 0;
};

/// All visits in machining order. Every way has its tools by rising number, so all can be merged so; the tool
/// that follows may come last where it is the last of its ways.
std::vector<Visit> visitsOf(const EdgeHelp& help, const ChosenWays& choice, int last) {
    std::vector<Visit> visits;
    for (std::size_t i = 0; i < help.lumps.size(); ++i) {
        const LumpWay& way = help.lumps[i]->ways()[choice.ways[i]];
        for (std::size_t k = 0; k < way.tools.size(); ++k)
            visits.push_back({i, choice.ways[i], k, way.tools[k]});
    }
    std::stable_sort(visits.begin(), visits.end(), [&](const Visit& a, const Visit& b) {
        const bool a_last = a.helper == last;
        const bool b_last = b.helper == last;
        return a_last != b_last ? b_last : a.helper < b.helper;
    });
    return visits;
}

}  // namespace

const ChosenWays& EdgeHelp::choice(int next) const {
    const auto found = before.find(next);
    return found == before.end() ? plain : found->second;
}

double EdgeHelp::saving(int next) const {
    return lumps.empty() ? 0 : plain.weight - choice(next).weight;
}

double EdgeHelp::largestSaving() const {
    double largest = 0;
    for (const auto& [next, choice] : before)
        largest = std::max(largest, plain.weight - choice.weight);
    return largest;
}

EdgeHelp findHelp(const SurrogateFinder& finder, const std::vector<Candidate>& tools, const Candidate* m,
                  int n, double change_weight) {
    EdgeHelp help;
    help.lumps = finder.lumpsOf(m != nullptr ? m->area : nullptr, *tools[n].area);
    std::vector<std::vector<LumpWay>> ways;
    for (const auto& lump : help.lumps)
        ways.push_back(lump->ways());
    help.plain = cheapestWays(ways, change_weight);
    if (!help.possible() || help.lumps.empty()) return help;
    for (int next = n + 1; next < static_cast<int>(tools.size()); ++next) {
        const int helper = finder.numberOf(*tools[next].tool);
        if (helper == kNoTool) continue;
        ChosenWays choice = cheapestWays(ways, change_weight, helper);
        if (choice.joins_next) help.before.emplace(next, std::move(choice));
    }
    return help;
}

void addHelp(const EdgeHelp& help, int next, const Machine& machine, DagEdge& edge) {
    if (help.lumps.empty()) return;
    const ChosenWays& choice = help.choice(next);
    int last_helper = kNoTool;
    for (const Visit& visit : visitsOf(help, choice, kNoTool)) {
        const SolvedLump& lump = *help.lumps[visit.lump];
        const ToolAssembly& tool = lump.tool(visit.helper);
        const PathTotals& totals = lump.totals(visit.way)[visit.place];
        if (visit.helper != last_helper) edge.surrogates.push_back({tool.id, 0, 0});
        const EdgeCost change = edgeCost({}, tool, machine);
        const EdgeCost visit_cost = edgeCost(totals, tool, machine);
        const bool pays_change = visit.helper != last_helper;
        edge.time_s += visit_cost.time_s - (pays_change ? 0 : change.time_s);
        edge.cost += visit_cost.cost - (pays_change ? 0 : change.cost);
        edge.motion_s += visit_cost.motion_s - (pays_change ? 0 : change.motion_s);
        edge.surrogates.back().area_mm2 += lump.area_mm2();
        edge.surrogates.back().time_s += totals.time_s();
        last_helper = visit.helper;
    }
    if (!choice.joins_next) return;
    // The tool that follows is the last of them, and its change counts on its own edge.
    const EdgeCost change = edgeCost(
        {}, help.lumps.front()->tool(help.lumps.front()->ways()[choice.ways.front()].tools.front()), machine);
    edge.time_s -= change.time_s;
    edge.cost -= change.cost;
    edge.motion_s -= change.motion_s;
}

std::vector<std::string> helpersBefore(const EdgeHelp& help, int next, const SurrogateFinder& finder,
                                       const std::vector<Candidate>& tools) {
    std::vector<std::string> helpers;
    if (help.lumps.empty()) return helpers;
    const ChosenWays& choice = help.choice(next);
    const int last = choice.joins_next ? finder.numberOf(*tools[next].tool) : kNoTool;
    for (const Visit& visit : visitsOf(help, choice, last)) {
        const std::string& id = help.lumps[visit.lump]->tool(visit.helper).id;
        if (helpers.empty() || helpers.back() != id) helpers.push_back(id);
    }
    return helpers;
}

std::vector<SequenceStep> helpSteps(const EdgeHelp& help, int next, const SurrogateFinder& finder,
                                    const std::vector<Candidate>& tools) {
    std::vector<SequenceStep> steps;
    if (help.lumps.empty()) return steps;
    const ChosenWays& choice = help.choice(next);
    const int last = choice.joins_next ? finder.numberOf(*tools[next].tool) : kNoTool;
    for (const Visit& visit : visitsOf(help, choice, last)) {
        steps.push_back(help.lumps[visit.lump]->step(visit.way, visit.place));
        steps.back().role = Role::Surrogate;
    }
    return steps;
}

}  // namespace stepmill
