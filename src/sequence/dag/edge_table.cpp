#include "sequence/dag/edge_table.h"

#include <algorithm>
#include <set>

#include "sequence/dag/step_paths.h"
#include "stepmill/core/parallel.h"
#include "stepmill/feature/hole_group.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/tool_dag.h"

namespace stepmill {
namespace {

double weigh(const EdgeCost& cost, const DagTask& task) {
    return weightOf(cost, task.options.objective);
}

double changeWeight(const DagTask& task) {
    return changeWeight(task.machine, task.options.objective);
}

void checkTime(const DagTask& task) {
    task.options.deadline.check(task.ground.feature().id);
}

/// No more goes in a second on the tool's way after another, as makePaths() weighs it [mm3/s].
double mostRemoved(const Candidate* from, const Candidate& to, const DagTask& task) {
    return isWeighedAsFed(task, from) ? to.rate_as_cut_mm3_per_s : to.volume_rate_mm3_per_s;
}

/// Least weight of an edge whose tool has surrogates: they clear what the tool itself does not. A surrogate
/// may wear less than the tool, so only machine time counts.
double leastWithLumps(const Candidate* from, const Candidate& to, double new_mm2, double own_new_mm2,
                      const DagTask& task) {
    const double own_mm2 = std::clamp(own_new_mm2, 0.0, new_mm2);
    const double depth_mm = task.ground.feature().depth_mm();
    const double least_s = own_mm2 * depth_mm / mostRemoved(from, to, task) +
                           (new_mm2 - own_mm2) * depth_mm / to.joint_rate_mm3_per_s;
    return changeWeight(task) + weigh(machineCost(least_s, task.machine), task);
}

/// May the mill go where the drill has made room? Its own rules are those of a larger tool before a smaller.
bool mayFollow(const Candidate& drill, const Candidate& mill) {
    return drill.predrills && !mill.drill() && !mill.hasSurrogates() && !mill.isLimited() &&
           mill.tool->diameter_mm <= drill.tool->diameter_mm;
}

/// Least weight of the mill after the drill that has made room for it: all that the drill leaves, at the
/// mill's best rate.
double leastAfterDrill(const Candidate& drill, const Candidate& mill, const DagTask& task) {
    if (!mayFollow(drill, mill)) return kNoEdge;
    const Feature& feature = task.ground.feature();
    const double drilled_mm3 = drill.coverable_mm2 * (feature.top_z_mm - preDrilledToZ(feature, *drill.tool));
    const double left_mm3 = mill.coverable_mm2 * feature.depth_mm() - drilled_mm3;
    PathTotals least;
    least.feed_time_s = std::max(0.0, left_mm3) / mostRemoved(&drill, mill, task);
    return weigh(edgeCost(least, *mill.tool, task.machine), task);
}

/// A hole deeper than so many diameters of a mill, and wider than it by less than this share, is drilled
/// before the mill comes, where a drill can: it would drill with its face, and chips have no way out.
constexpr double kPlungedDiameters = 2;
constexpr double kHardlyWiderShare = 0.25;

bool isDrilledBefore(const Candidate& mill, const DagTask& task) {
    const Feature& feature = task.ground.feature();
    const double mill_mm = mill.tool->diameter_mm;
    if (!isHole(feature.feature_class) || feature.depth_mm() <= kPlungedDiameters * mill_mm) return false;
    if (2 * holeRadiusMm(feature) >= (1 + kHardlyWiderShare) * mill_mm) return false;
    return std::any_of(task.tools.begin(), task.tools.end(),
                       [&](const Candidate& drill) { return mayFollow(drill, mill); });
}

/// Where a spot is wanted and can be made, the drill comes after it; else drills and spots come first.
bool mayCome(const Candidate* from, const Candidate& to, const DagTask& task) {
    if (from != nullptr && from->spots) return to.wantsSpot();
    if (to.mills()) return from != nullptr || !isDrilledBefore(to, task);
    return from == nullptr && !(to.wantsSpot() && task.tools.front().spots);
}

/// Lower bound of an edge's weight: the area that the tool covers and the one before it does not, cut at the
/// best rates, or the walls that it touches and the one before it does not, and one tool change. A surrogate
/// saves no more than its own change, which the bound leaves out.
double lowerBound(const Candidate* from, const Candidate& to, const DagTask& task) {
    if (!mayCome(from, to, task)) return kNoEdge;
    if (to.spots) return changeWeight(task);
    if (from != nullptr && from->spots) from = nullptr;
    if (from != nullptr && from->drill()) return leastAfterDrill(*from, to, task);
    if (from != nullptr && from->tool == to.tool) return kNoEdge;
    const Feature& feature = task.ground.feature();
    const double from_mm2 = from != nullptr ? from->coverable_mm2 : 0;
    const double new_mm2 = to.coverable_mm2 - from_mm2;
    if (new_mm2 <= sameArea(feature, task.ground.tolerances())) return kNoEdge;
    if (to.hasSurrogates())
        return leastWithLumps(from, to, new_mm2, to.own->coverable_area_mm2 - from_mm2, task);
    PathTotals least;
    least.feed_time_s =
        std::max(new_mm2 * feature.depth_mm() / mostRemoved(from, to, task), leastWallS(from, to));
    return weigh(edgeCost(least, *to.tool, task.machine), task);
}

/// Of each tool: may the sequence begin with it?
std::vector<bool> firstTools(const DagTask& task) {
    const auto is_wide = [&](const Candidate& tool) {
        return tool.mills() && tool.tool->diameter_mm >= task.first_at_least_mm;
    };
    const bool any = std::any_of(task.tools.begin(), task.tools.end(), is_wide);
    std::vector<bool> first;
    for (const Candidate& tool : task.tools)
        first.push_back(!any || !tool.mills() || is_wide(tool));
    return first;
}

}  // namespace

EdgeTable::EdgeTable(const DagTask& task) : task_(task), n_(static_cast<int>(task.tools.size())) {
    slots_.resize(static_cast<std::size_t>(n_ + 1) * n_);
    rings_.resize(n_);
    const std::vector<bool> first = firstTools(task);
    for (int m = kSource; m < n_; ++m) {
        for (int n = m + 1; n < n_; ++n)
            if (m != kSource || first[n]) slot(m, n).least_weight = lowerBound(tool(m), task.tools[n], task);
    }
}

int EdgeTable::evaluate(const EdgeList& edges, double known) {
    makeMissingRings(edges);
    if (known < kNoEdge) {
        onward_.clear();
        for (int n = 0; n < n_; ++n)
            onward_.push_back(leastOnward(n));
    }
    std::vector<char> left_out(edges.size(), 0);
    parallelFor(edges.size(), [&](std::size_t i) {
        checkTime(task_);
        const auto [m, n] = edges[i];
        slot(m, n).settled = true;
        left_out[i] = evaluate(m, n, known, slot(m, n)) ? 0 : 1;
    });
    return static_cast<int>(std::count(left_out.begin(), left_out.end(), 1));
}

/// A tool with surrogates goes itself where it goes alone.
int EdgeTable::sameWork(int n) const {
    return n > 0 && task_.tools[n - 1].own == task_.tools[n].own ? n - 1 : n;
}

/// The edges into one tool share its rings; a tool that no edge leads to needs none.
void EdgeTable::makeMissingRings(const EdgeList& edges) {
    std::set<int> missing;
    for (const auto& [m, n] : edges) {
        if (!rings_[sameWork(n)] && task_.tools[n].mills() && needsPaths(task_)) missing.insert(sameWork(n));
    }
    const std::vector<int> tools(missing.begin(), missing.end());
    parallelFor(tools.size(), [&](std::size_t i) {
        checkTime(task_);
        rings_[tools[i]] = ringsOf(task_, task_.tools[tools[i]]);
    });
    for (const auto& [m, n] : edges)
        rings_[n] = rings_[sameWork(n)];
}

/// False when the edge was left out.
bool EdgeTable::evaluate(int m, int n, double known, Slot& into) const {
    const Candidate& to = task_.tools[n];
    const Candidate* from = tool(m);
    const std::optional<EdgeWork> work =
        works_.get({m, sameWork(n)}, [&] { return edgeWork(task_, from, to, rings_[n]); });
    if (!work) return true;
    const EdgeCost cost = edgeCost(work->totals, *to.tool, task_.machine);
    const double own_weight = weigh(cost, task_);
    if (to.hasSurrogates() && task_.surrogates != nullptr) {
        if (!mayBeatWithLumps(m, n, own_weight, work->new_area_mm2, known)) return false;
        into.surrogates = surrogatesOfEdge(*task_.surrogates, task_.tools, from, n, changeWeight(task_));
        if (!into.surrogates.possible()) return true;
    }
    into.edge.from = from != nullptr ? from->node() : DagNode{};
    into.edge.to = to.node();
    into.edge.region_area_mm2 = work->region_area_mm2;
    into.edge.totals = work->totals;
    into.edge.time_s = cost.time_s;
    into.edge.cost = cost.cost;
    into.edge.motion_s = cost.motion_s;
    into.weight = own_weight + into.surrogates.plain.weight;
    return true;
}

/// Can a path through the edge be as cheap as `known`, given the weight of n's own path?
bool EdgeTable::mayBeatWithLumps(int m, int n, double own_weight, double own_new_mm2, double known) const {
    if (known == kNoEdge) return true;
    const Candidate& to = task_.tools[n];
    const double from_mm2 = m == kSource ? 0 : task_.tools[m].coverable_mm2;
    const double lumps_mm2 = std::max(0.0, to.coverable_mm2 - from_mm2 - own_new_mm2);
    const double lumps_s = lumps_mm2 * task_.ground.feature().depth_mm() / to.joint_rate_mm3_per_s;
    const double before = m == kSource ? 0 : to_tool_[m];
    return before + own_weight + weigh(machineCost(lumps_s, task_.machine), task_) +
               leastAfter(n, lumps_mm2) <=
           known;
}

std::vector<WeighedEdge> EdgeTable::evaluated() const {
    std::vector<WeighedEdge> edges;
    for (int m = kSource; m < n_; ++m) {
        for (int n = m + 1; n < n_; ++n) {
            const Slot& at = slot(m, n);
            if (at.weight < kNoEdge) edges.push_back({m, n, at.edge, at.surrogates, at.weight});
        }
    }
    return edges;
}

void EdgeTable::bound() {
    to_tool_.assign(n_, kNoEdge);
    for (int n = 0; n < n_; ++n) {
        to_tool_[n] = slot(kSource, n).bound();
        for (int m = 0; m < n; ++m)
            to_tool_[n] = std::min(to_tool_[n], to_tool_[m] + slot(m, n).bound());
    }
    to_sink_.assign(n_, kNoEdge);
    for (int m = n_; m-- > 0;)
        to_sink_[m] = task_.ends[m] ? std::min(0.0, leastOnward(m)) : leastOnward(m);
}

/// Lower bound of the ways from tool n by way of another to the sink.
double EdgeTable::leastOnward(int n) const {
    double least = kNoEdge;
    for (int next = n + 1; next < n_; ++next)
        least = std::min(least, slot(n, next).bound() + to_sink_[next]);
    return least;
}

/// Least weight of all that follows tool n. Who clears its lumps is a tool that follows anyway, or one change
/// more.
double EdgeTable::leastAfter(int n, double lumps_mm2) const {
    if (lumps_mm2 <= sameArea(task_.ground.feature(), task_.ground.tolerances())) return to_sink_[n];
    return task_.ends[n] ? std::min(changeWeight(task_), onward_[n]) : onward_[n];
}

bool EdgeTable::mayBeat(int m, int n, double known) const {
    const double least = leastThrough(m, n);
    return least < kNoEdge && least <= known;
}

double EdgeTable::leastThrough(int m, int n) const {
    const double before = m == kSource ? 0 : to_tool_[m];
    return before + slot(m, n).least_weight + to_sink_[n];
}

}  // namespace stepmill
