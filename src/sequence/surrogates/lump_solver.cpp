#include "sequence/surrogates/lump_solver.h"

#include <algorithm>
#include <numeric>

#include <tbb/task_arena.h>

#include "sequence/dag/step_paths.h"
#include "stepmill/access/collision.h"
#include "stepmill/core/error.h"
#include "stepmill/core/parallel.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/sequence/machine_limits.h"

namespace stepmill {
namespace {

/// Where no tool reaches all of a lump, sets of tools may do so together: the largest set, the number of sets
/// whose areas are looked at, and the number of sets that get paths.
constexpr std::size_t kMostTogether = 3;
constexpr int kMostSetsSeen = 400;
constexpr std::size_t kMostSetsWeighed = 12;

}  // namespace

LumpSolver::LumpSolver(std::shared_ptr<const SurrogateTools> surrogates, Region lump,
                       std::vector<Region> standing, const std::string& held_off_id)
    : tools_(std::move(surrogates), std::move(lump), std::move(standing)) {
    sortSurrogates(held_off_id);
    servable_ = anyReachesAll();
    if (servable_) return;
    tools_.clear();
    tools_.offer(partialSurrogates());
    servable_ = sequencesCount() && anySetReachesAll();
    if (!servable_) unserved_ = residualOfTheBest();
}

void LumpSolver::weigh() {
    if (!servable_) return;
    const bool one_does = offered_ > 0;
    one_does ? weighOneByOne() : weighSets();
    tools_.dropRings();
}

void LumpSolver::weighOneByOne() {
    weighSingles();
    tools_.offer(othersThatMayPay());
    weighSingles();
    if (sequencesCount() && mayPayTwo()) weighSequences();
}

void LumpSolver::sortSurrogates(const std::string& held_off_id) {
    const double depth_mm = job().feature().depth_mm();
    for (int i = 0; i < static_cast<int>(tools_.surrogates().size()); ++i) {
        const Surrogate& surrogate = tools_.surrogates()[i];
        if (surrogate.tool->id == held_off_id) continue;
        // Other lumps and the rest of this one stand beside it up to the feature's top.
        if (job().options.clear_of_own_material && access::freeReachMm(*surrogate.tool) < depth_mm) continue;
        const bool whole = covers(surrogate.reach.coverable, tools_.lump(), tol().sliver_mm, tol());
        (whole ? whole_ : partial_).push_back(i);
    }
}

/// Offers the surrogates that reach all of the lump in the whole feature, one by one, until one of them still
/// reaches all of it beside what stands around the lump: mostly the first does.
bool LumpSolver::anyReachesAll() {
    while (offered_ < whole_.size()) {
        tools_.offer({whole_[offered_++]});
        if (tools_.anyEnds()) return true;
    }
    offered_ = 0;
    return false;
}

std::vector<int> LumpSolver::partialSurrogates() const {
    std::vector<int> found;
    for (const int surrogate : partial_) {
        const Region& reach = tools_.surrogates()[surrogate].reach.coverable;
        if (area(intersect(reach, tools_.lump(), tol())) > tol().area_mm2) found.push_back(surrogate);
    }
    return found;
}

/// Mostly not even all tools together reach all, and no set has to be looked at.
bool LumpSolver::anySetReachesAll() {
    findWitnesses();
    std::vector<int> all(tools_.nodes().size());
    std::iota(all.begin(), all.end(), 0);
    bool found = false;
    if (!all.empty() && reachAllTogether(all))
        visitSets([&](const std::vector<int>& nodes) {
            found = reachAllTogether(nodes);
            return !found;
        });
    return found;
}

/// What stays of the lump after the largest set of tools, chosen one by one so that each leaves least.
Region LumpSolver::residualOfTheBest() const {
    Region residual = tools_.lump();
    const std::size_t most = sequencesCount() ? kMostTogether : 1;
    for (std::size_t i = 0; i < most && !residual.empty(); ++i) {
        Region least = residual;
        for (const Candidate& tool : tools_.nodes()) {
            Region rest = subtract(residual, tool.cleared->coverable, tol());
            if (area(rest) < area(least)) least = std::move(rest);
        }
        residual = withoutCrumbs(least, tol());
    }
    return residual;
}

/// Calls `visit` with all sets of two tools, then of three, until it returns false or enough were seen.
template <typename Visit>
void LumpSolver::visitSets(const Visit& visit) const {
    int seen = 0;
    bool more = true;
    std::vector<int> nodes;
    const auto extend = [&](auto& self, std::size_t size, int first) -> void {
        if (nodes.size() == size) {
            more = seen++ < kMostSetsSeen && visit(nodes);
            return;
        }
        for (int node = first; node < static_cast<int>(tools_.nodes().size()) && more; ++node) {
            nodes.push_back(node);
            self(self, size, node + 1);
            nodes.pop_back();
        }
    };
    for (std::size_t size = 2; size <= kMostTogether && more; ++size)
        extend(extend, size, 0);
}

/// Takes the middles of what each tool leaves. A set of tools that all leave a disc around such a place,
/// wider than a strip, does not reach all, and its areas need not be united to know it.
void LumpSolver::findWitnesses() {
    witnesses_.clear();
    std::vector<Region> left(tools_.nodes().size());
    std::vector<std::vector<Vec2>> middles(left.size());
    parallelFor(left.size(), [&](std::size_t i) {
        left[i] = subtract(tools_.lump(), tools_.nodes()[i].cleared->coverable, tol());
        for (const Region& part : components(left[i]))
            if (const auto disc = ClearanceDiagram(part, tol()).largestInscribedDisc())
                middles[i].push_back(disc->centre);
    });
    const auto reaches = [&](std::size_t node, const Vec2& at) {
        return !contains(left[node], at) || distanceToBoundary(left[node], at) <= tol().sliver_mm;
    };
    for (const std::vector<Vec2>& places : middles)
        for (const Vec2& at : places) {
            std::vector<bool> reached(left.size());
            for (std::size_t node = 0; node < left.size(); ++node)
                reached[node] = reaches(node, at);
            witnesses_.push_back(std::move(reached));
        }
}

bool LumpSolver::reachAllWitnesses(const std::vector<int>& nodes) const {
    return std::all_of(witnesses_.begin(), witnesses_.end(), [&](const std::vector<bool>& reached) {
        return std::any_of(nodes.begin(), nodes.end(), [&](int node) { return reached[node]; });
    });
}

bool LumpSolver::reachAllTogether(const std::vector<int>& nodes) const {
    if (!reachAllWitnesses(nodes)) return false;
    std::vector<Region> areas;
    areas.reserve(nodes.size());
    for (const int node : nodes)
        areas.push_back(tools_.nodes()[node].cleared->coverable);
    return covers(unite(areas, tol()), tools_.lump(), tol().sliver_mm, tol());
}

double LumpSolver::weight(const EdgeCost& cost) const {
    return weightOf(cost, job().options.objective);
}

double LumpSolver::changeWeight() const {
    return stepmill::changeWeight(job().machine, job().options.objective);
}

void LumpSolver::addWay(const std::vector<int>& nodes, std::vector<PathTotals> totals) {
    LumpWay way;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const ToolAssembly& tool = *tools_.nodes()[nodes[i]].tool;
        way.tools.push_back(tools_.surrogateOf(nodes[i]));
        way.weight += weight(edgeCost(totals[i], tool, job().machine)) - changeWeight();
    }
    ways_.push_back(std::move(way));
    totals_.push_back(std::move(totals));
}

/// Of the surrogates that were not offered yet those that may be chosen: one that takes longer than the
/// cheapest with its change is not, whoever else needs it.
std::vector<int> LumpSolver::othersThatMayPay() const {
    const double most = cheapestWay() + changeWeight();
    std::vector<int> others;
    for (std::size_t i = offered_; i < whole_.size(); ++i)
        if (leastWeight(rateOf(tools_.surrogates()[whole_[i]])) < most) others.push_back(whole_[i]);
    return others;
}

/// Those nodes that clear the whole lump and are not weighed yet; others are dropped.
void LumpSolver::weighSingles() {
    tools_.keepEnds();
    std::vector<int> nodes;
    for (int node = 0; node < static_cast<int>(tools_.nodes().size()); ++node) {
        const std::vector<int> way{tools_.surrogateOf(node)};
        const bool weighed =
            std::any_of(ways_.begin(), ways_.end(), [&](const LumpWay& known) { return known.tools == way; });
        if (!weighed) nodes.push_back(node);
    }
    tools_.makeRings(nodes);
    std::vector<std::optional<PathTotals>> totals(nodes.size());
    parallelFor(nodes.size(), [&](std::size_t i) { totals[i] = tools_.totalsOf(kSource, nodes[i]); });
    for (std::size_t i = 0; i < nodes.size(); ++i)
        if (totals[i]) addWay({nodes[i]}, {*totals[i]});
}

double LumpSolver::cheapestWay() const {
    double cheapest = kNoEdge;
    for (const LumpWay& way : ways_)
        cheapest = std::min(cheapest, way.weight);
    return cheapest;
}

/// Could two tools and their changes be cheaper than the cheapest one?
bool LumpSolver::mayPayTwo() const {
    double fastest = 0;
    for (const Surrogate& surrogate : tools_.surrogates())
        fastest = std::max(fastest, rateOf(surrogate));
    // Two tools are one change more.
    return changeWeight() + leastWeight(fastest) < cheapestWay();
}

/// Least weight of clearing the lump at no more than that rate.
double LumpSolver::leastWeight(double mm3_per_s) const {
    const double least_s = mm3_per_s > 0 ? tools_.ground().feature().volume_mm3 / mm3_per_s : 0;
    return weight(machineCost(least_s, job().machine));
}

double LumpSolver::rateOf(const Surrogate& surrogate) const {
    const CuttingData cutting = limitedBy(job().machine, *surrogate.tool->cuttingFor(job().options.material));
    return volumeRate(job().feature(), *surrogate.tool, cutting);
}

/// Adds the cheapest sequence where it has more than one tool. A tool that reaches all comes last, so the
/// lump is clear after it whatever the others reach.
void LumpSolver::weighSequences() {
    const double alone = cheapestWay();
    tools_.offer(partialSurrogates());
    DagTask several = tools_.task();
    several.alone_weight = changeWeight() + alone;
    const DagResult dag = evaluateDag(several);
    tools_.useRings(dag.rings);
    if (!dag.path.empty()) weighInARow(dag.path);
}

bool LumpSolver::weighInARow(const std::vector<int>& nodes) {
    tools_.makeRings(nodes);
    std::vector<PathTotals> totals;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto path = tools_.totalsOf(i == 0 ? kSource : nodes[i - 1], nodes[i]);
        if (!path) return false;
        totals.push_back(*path);
    }
    addWay(nodes, std::move(totals));
    return true;
}

/// Adds the smallest sets of tools that reach all of the lump together.
void LumpSolver::weighSets() {
    std::size_t smallest = kMostTogether;
    visitSets([&](const std::vector<int>& nodes) {
        if (nodes.size() > smallest) return false;
        if (reachAllTogether(nodes) && weighInARow(nodes)) smallest = nodes.size();
        return ways_.size() < kMostSetsWeighed;
    });
}

SequenceStep LumpSolver::step(int way, std::size_t place) const {
    const std::vector<int>& tools = ways_[way].tools;
    const auto nodeAt = [&](std::size_t i) { return &tools_.nodes()[tools_.nodeOf(tools[i])]; };
    const Candidate& node = *nodeAt(place);
    SequenceStep step = makeStep(tools_.task(), place == 0 ? nullptr : nodeAt(place - 1), node);
    // The lump knows no obstacles of its own; the feature does.
    step.least_stick_out_mm = leastStickOutMm(job().ground, *node.tool, *node.own);
    return step;
}

SolvedLump::SolvedLump(std::unique_ptr<LumpSolver> solver) : solver_(std::move(solver)) {}
SolvedLump::~SolvedLump() = default;

bool SolvedLump::servable() const {
    return solver_->servable();
}

const Region& SolvedLump::unserved() const {
    return solver_->unserved();
}

double SolvedLump::area_mm2() const {
    return solver_->area_mm2();
}

const ToolAssembly& SolvedLump::tool(int surrogate) const {
    return solver_->toolOf(surrogate);
}

const std::vector<LumpWay>& SolvedLump::ways() const {
    return weighed().ways();
}

const std::vector<PathTotals>& SolvedLump::totals(int way) const {
    return weighed().totals()[way];
}

SequenceStep SolvedLump::step(int way, std::size_t place) const {
    return weighed().step(way, place);
}

const LumpSolver& SolvedLump::weighed() const {
    std::call_once(weighed_, [&] {
        // While a thread waits for these paths it must not take other work that waits for them too.
        tbb::this_task_arena::isolate([&] { solver_->weigh(); });
    });
    return *solver_;
}

}  // namespace stepmill
