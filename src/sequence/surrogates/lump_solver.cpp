#include "sequence/surrogates/lump_solver.h"

#include <algorithm>
#include <numeric>

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include "sequence/dag/edge_work.h"
#include "stepmill/access/collision.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/machine_limits.h"

namespace stepmill {
namespace {

/// A way in over an open edge starts up to 1 mm beside the material; nothing of a lump's path goes
/// farther from it than the cutter's diameter and this [mm].
constexpr double kBesideMm = 2;

/// Where no tool reaches all of a lump: how many are asked to do it together, how many such sets are
/// looked at, and how many of those that can get their paths.
constexpr std::size_t kMostTogether = 3;
constexpr int kMostSetsSeen = 400;
constexpr std::size_t kMostSetsWeighed = 12;

}  // namespace

LumpSolver::LumpSolver(std::shared_ptr<const SurrogateTools> tools, Region lump, std::vector<Region> standing,
                       std::string held_off_id)
    : surrogates_(std::move(tools)),
      tol_(job().tolerances()),
      lump_(std::move(lump)),
      standing_(std::move(standing)),
      held_off_id_(std::move(held_off_id)),
      // What stands differs from tool to tool, by its holder: it comes with the tools' areas.
      ground_(lumpFeature(job().feature(), lump_, {}, 0, tol_), tol_) {
    sortSurrogates();
    servable_ = anyReachesAll();
    if (servable_) return;
    reaches_.clear();
    numbers_.clear();
    offer(partialSurrogates());
    if (sequencesCount())
        visitSets([&](const std::vector<int>& nodes) {
            servable_ = servable_ || reachAllTogether(nodes);
            return !servable_;
        });
    if (!servable_) unserved_ = residualOfTheBest();
}

void LumpSolver::weigh() {
    if (!servable_) return;
    const bool one_does = offered_ > 0;
    if (!one_does) return weighSets();
    offer({whole_.begin() + static_cast<std::ptrdiff_t>(offered_), whole_.end()});
    keepWholeSurrogates();
    weighSingles();
    if (sequencesCount() && mayPayTwo()) weighSequences();
}

void LumpSolver::sortSurrogates() {
    for (int i = 0; i < static_cast<int>(surrogates_->all().size()); ++i) {
        if (surrogate(i).tool->id == held_off_id_) continue;
        // Other lumps and the rest of this one stand beside it up to the feature's top.
        if (job().options.clear_of_own_material &&
            access::freeReachMm(*surrogate(i).tool) < job().feature().depth_mm())
            continue;
        const bool whole = covers(surrogate(i).reach.coverable, lump_, tol_.sliver_mm, tol_);
        (whole ? whole_ : partial_).push_back(i);
    }
}

/// Offers the surrogates that reach all of the lump in the whole feature, one by one, until one does so with
/// what stands around the lump too: mostly the first.
bool LumpSolver::anyReachesAll() {
    while (offered_ < whole_.size()) {
        offer({whole_[offered_++]});
        if (std::count(ends_.begin(), ends_.end(), true) > 0) return true;
    }
    offered_ = 0;
    return false;
}

/// The reach of a surrogate in the lump, holder clear, nothing that stands around it touched.
ToolReach LumpSolver::reachIn(int number) const {
    const ToolAssembly& tool = *surrogate(number).tool;
    std::vector<Region> obstruction = standing_;
    obstruction.push_back(surrogates_->obstruction(number));
    const Feature feature =
        lumpFeature(job().feature(), lump_, obstruction, tool.diameter_mm + kBesideMm, tol_);
    const FeatureGround ground(feature, tol_);
    ToolReach found = toolReach(ground, tool, job().options.material);
    found.cutter.wider_obstruction = feature.obstruction;
    found.cutter.opens_target = false;
    return found;
}

/// Adds the surrogates' reaches to those there are, all by rising number.
void LumpSolver::offer(const std::vector<int>& surrogates) {
    std::vector<ToolReach> found(surrogates.size());
    tbb::parallel_for(std::size_t{0}, surrogates.size(),
                      [&](std::size_t i) { found[i] = reachIn(surrogates[i]); });
    std::vector<std::pair<int, ToolReach>> all;
    for (std::size_t i = 0; i < reaches_.size(); ++i)
        all.emplace_back(numbers_[i], std::move(reaches_[i]));
    for (std::size_t i = 0; i < surrogates.size(); ++i)
        all.emplace_back(surrogates[i], std::move(found[i]));
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    numbers_.clear();
    reaches_.clear();
    for (auto& [surrogate, reach] : all) {
        numbers_.push_back(surrogate);
        reaches_.push_back(std::move(reach));
    }
    listTools();
}

void LumpSolver::listTools() {
    tools_ = usableTools(ground_.feature(), reaches_, job().library, job().options, job().machine, tol_);
    surrogate_of_.clear();
    ends_.clear();
    for (const Candidate& tool : tools_) {
        surrogate_of_.push_back(surrogateOf(tool));
        ends_.push_back(covers(tool.cleared->coverable, lump_, tol_.sliver_mm, tol_));
    }
    rings_.assign(tools_.size(), nullptr);
}

std::size_t LumpSolver::nodeOf(int surrogate) const {
    const auto found = std::find(surrogate_of_.begin(), surrogate_of_.end(), surrogate);
    STEPMILL_CHECK(found != surrogate_of_.end(), "only tools of a lump's ways work in it");
    return static_cast<std::size_t>(found - surrogate_of_.begin());
}

void LumpSolver::keepWholeSurrogates() {
    std::vector<ToolReach> reaches;
    std::vector<int> numbers;
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        if (!ends_[i]) continue;
        numbers.push_back(surrogate_of_[i]);
        reaches.push_back(*tools_[i].reach);
    }
    numbers_ = std::move(numbers);
    reaches_ = std::move(reaches);
    listTools();
}

std::vector<int> LumpSolver::partialSurrogates() const {
    std::vector<int> found;
    for (const int surrogate : partial_) {
        const Region& reach = this->surrogate(surrogate).reach.coverable;
        if (area(intersect(reach, lump_, tol_)) > tol_.area_mm2) found.push_back(surrogate);
    }
    return found;
}

/// What stays of the lump after as many tools as may work together, chosen one after another so that each
/// leaves least.
Region LumpSolver::residualOfTheBest() const {
    Region residual = lump_;
    const std::size_t most = sequencesCount() ? kMostTogether : 1;
    for (std::size_t i = 0; i < most && !residual.empty(); ++i) {
        Region least = residual;
        for (const Candidate& tool : tools_) {
            Region rest = withoutCrumbs(subtract(residual, tool.cleared->coverable, tol_), tol_);
            if (area(rest) < area(least)) least = std::move(rest);
        }
        residual = std::move(least);
    }
    return residual;
}

/// Shows all sets of two tools, then of three, until `visit` says no or enough were seen.
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
        for (int node = first; node < static_cast<int>(tools_.size()) && more; ++node) {
            nodes.push_back(node);
            self(self, size, node + 1);
            nodes.pop_back();
        }
    };
    for (std::size_t size = 2; size <= kMostTogether && more; ++size)
        extend(extend, size, 0);
}

bool LumpSolver::reachAllTogether(const std::vector<int>& nodes) const {
    std::vector<Region> areas;
    areas.reserve(nodes.size());
    for (const int node : nodes)
        areas.push_back(tools_[node].cleared->coverable);
    return covers(unite(areas, tol_), lump_, tol_.sliver_mm, tol_);
}

double LumpSolver::weight(const EdgeCost& cost) const {
    return weightOf(cost, job().options.objective);
}

double LumpSolver::changeWeight() const {
    return weight(edgeCost({}, *tools_.front().tool, job().machine));
}

void LumpSolver::addWay(const std::vector<int>& nodes, std::vector<PathTotals> totals) {
    LumpWay way;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const ToolAssembly& tool = *tools_[nodes[i]].tool;
        way.tools.push_back(surrogate_of_[nodes[i]]);
        way.weight +=
            weight(edgeCost(totals[i], tool, job().machine)) - weight(edgeCost({}, tool, job().machine));
    }
    ways_.push_back(std::move(way));
    totals_.push_back(std::move(totals));
}

/// The path of one after another (-1: nothing yet); nothing when there is nothing new to clear.
std::optional<PathTotals> LumpSolver::totalsOf(int before, int node) const {
    const Candidate* from = before < 0 ? nullptr : &tools_[before];
    const auto work = edgeWork(task(), from, tools_[node], rings_[node]);
    return work ? std::optional(work->totals) : std::nullopt;
}

void LumpSolver::makeRingsOf(const std::vector<int>& nodes) {
    tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t i) {
        SharedRings& rings = rings_[nodes[i]];
        if (!rings && needsPaths(task())) rings = ringsOf(task(), tools_[nodes[i]]);
    });
}

void LumpSolver::weighSingles() {
    std::vector<int> nodes(tools_.size());
    std::iota(nodes.begin(), nodes.end(), 0);
    makeRingsOf(nodes);
    std::vector<std::optional<PathTotals>> totals(nodes.size());
    tbb::parallel_for(std::size_t{0}, nodes.size(),
                      [&](std::size_t i) { totals[i] = totalsOf(-1, nodes[i]); });
    for (const int node : nodes)
        if (totals[node]) addWay({node}, {*totals[node]});
}

/// Could two tools and their changes be cheaper than the cheapest one?
bool LumpSolver::mayPayTwo() const {
    double cheapest = kNoEdge;
    for (const LumpWay& way : ways_)
        cheapest = std::min(cheapest, way.weight);
    double fastest = 0;
    for (const Surrogate& surrogate : surrogates_->all())
        fastest = std::max(fastest, rateOf(surrogate));
    const double least_s = fastest > 0 ? ground_.feature().volume_mm3 / fastest : 0;
    // Two tools are one change more.
    return changeWeight() + weight(machineCost(least_s, job().machine)) < cheapest;
}

double LumpSolver::rateOf(const Surrogate& surrogate) const {
    const CuttingData cutting = limitedBy(job().machine, *surrogate.tool->cuttingFor(job().options.material));
    return volumeRate(job().feature(), *surrogate.tool, cutting);
}

/// The cheapest sequence, where it has more than one tool. A tool that reaches all comes last, so what it
/// clears after others is right whatever these reach.
void LumpSolver::weighSequences() {
    double alone = kNoEdge;
    for (const LumpWay& way : ways_)
        alone = std::min(alone, way.weight);
    offer(partialSurrogates());
    DagTask several = task();
    several.alone_weight = changeWeight() + alone;
    const DagResult dag = evaluateDag(several);
    rings_ = dag.rings;
    if (!dag.path.empty()) weighInARow(dag.path);
}

bool LumpSolver::weighInARow(const std::vector<int>& nodes) {
    makeRingsOf(nodes);
    std::vector<PathTotals> totals;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto path = totalsOf(i == 0 ? -1 : nodes[i - 1], nodes[i]);
        if (!path) return false;
        totals.push_back(*path);
    }
    addWay(nodes, std::move(totals));
    return true;
}

/// Sets of tools of which none reaches all, the smallest sets that can.
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
    const Candidate* before = place == 0 ? nullptr : &tools_[nodeOf(tools[place - 1])];
    const std::size_t node = nodeOf(tools[place]);
    SequenceStep step = makeStep(task(), before, tools_[node]);
    // The lump knows no obstacles of its own; the feature does.
    step.least_stick_out_mm = leastStickOutMm(job().ground, *tools_[node].tool, *tools_[node].own);
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
        // A thread that waits for its own paths must not take up work that asks for them too.
        tbb::this_task_arena::isolate([&] { solver_->weigh(); });
    });
    return *solver_;
}

}  // namespace stepmill
