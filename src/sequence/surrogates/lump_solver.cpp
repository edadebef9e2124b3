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

LumpSolver::LumpSolver(const LumpSettings& settings, Region lump, std::vector<Region> standing,
                       std::string held_off_id)
    : settings_(settings),
      tol_(settings.ground.tolerances()),
      lump_(std::move(lump)),
      standing_(std::move(standing)),
      held_off_id_(std::move(held_off_id)),
      // What stands differs from tool to tool, by its holder: it comes with the tools' areas.
      ground_(lumpFeature(settings.ground.feature(), lump_, {}, 0, tol_), tol_) {
    sortHelpers();
    servable_ = anyReachesAll();
    if (servable_) return;
    areas_.clear();
    numbers_.clear();
    offer(thoseWhoReachSome());
    if (sequencesCount())
        visitSets([&](const std::vector<int>& nodes) {
            servable_ = servable_ || reachAllTogether(nodes);
            return !servable_;
        });
    if (!servable_) unserved_ = leftByTheBest();
}

void LumpSolver::weigh() {
    if (!servable_) return;
    const bool one_does = offered_ > 0;
    if (!one_does) return weighSets();
    offer({whole_.begin() + static_cast<std::ptrdiff_t>(offered_), whole_.end()});
    keepThoseWhoReachAll();
    weighSingles();
    if (sequencesCount() && mayPayTwo()) weighSequences();
}

void LumpSolver::sortHelpers() {
    for (int i = 0; i < static_cast<int>(settings_.helpers.size()); ++i) {
        const AccessibleArea& reach = *settings_.helpers[i].reach;
        if (reach.tool_id == held_off_id_) continue;
        // Other lumps and the rest of this one stand beside it up to the feature's top.
        if (settings_.options.clear_of_own_material &&
            access::freeReachMm(*settings_.helpers[i].tool) < settings_.ground.feature().depth_mm())
            continue;
        (covers(reach.coverable, lump_, tol_.sliver_mm, tol_) ? whole_ : partial_).push_back(i);
    }
}

/// Mostly the first that does in the whole feature does in the lump, where more may stand around.
bool LumpSolver::anyReachesAll() {
    while (offered_ < whole_.size()) {
        offer({whole_[offered_++]});
        if (std::count(ends_.begin(), ends_.end(), true) > 0) return true;
    }
    offered_ = 0;
    return false;
}

/// The area of a helper in the lump, holder clear, nothing that stands around it touched.
AccessibleArea LumpSolver::areaIn(int helper) const {
    const ToolAssembly& tool = *settings_.helpers[helper].tool;
    std::vector<Region> obstruction = standing_;
    obstruction.push_back(settings_.obstruction(helper));
    const Feature feature =
        lumpFeature(settings_.ground.feature(), lump_, obstruction, tool.diameter_mm + kBesideMm, tol_);
    const FeatureGround ground(feature, tol_);
    AccessibleArea found = accessibleArea(ground, tool, settings_.options.material);
    found.obstruction = std::make_shared<const Region>(feature.obstruction);
    found.opens_target = false;
    return found;
}

/// Adds the helpers' areas to those there are, all by rising number.
void LumpSolver::offer(const std::vector<int>& helpers) {
    std::vector<AccessibleArea> found(helpers.size());
    tbb::parallel_for(std::size_t{0}, helpers.size(), [&](std::size_t i) { found[i] = areaIn(helpers[i]); });
    std::vector<std::pair<int, AccessibleArea>> all;
    for (std::size_t i = 0; i < areas_.size(); ++i)
        all.emplace_back(numbers_[i], std::move(areas_[i]));
    for (std::size_t i = 0; i < helpers.size(); ++i)
        all.emplace_back(helpers[i], std::move(found[i]));
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    numbers_.clear();
    areas_.clear();
    for (auto& [helper, area] : all) {
        numbers_.push_back(helper);
        areas_.push_back(std::move(area));
    }
    listTools();
}

void LumpSolver::listTools() {
    tools_ =
        usableTools(ground_.feature(), areas_, settings_.library, settings_.options, settings_.machine, tol_);
    helpers_.clear();
    ends_.clear();
    for (const Candidate& tool : tools_) {
        helpers_.push_back(helperOf(tool));
        ends_.push_back(covers(tool.area->coverable, lump_, tol_.sliver_mm, tol_));
    }
    rings_.assign(tools_.size(), nullptr);
}

std::size_t LumpSolver::nodeOf(int helper) const {
    const auto found = std::find(helpers_.begin(), helpers_.end(), helper);
    STEPMILL_CHECK(found != helpers_.end(), "only tools of a lump's ways work in it");
    return static_cast<std::size_t>(found - helpers_.begin());
}

void LumpSolver::keepThoseWhoReachAll() {
    std::vector<AccessibleArea> areas;
    std::vector<int> numbers;
    for (std::size_t i = 0; i < tools_.size(); ++i) {
        if (!ends_[i]) continue;
        numbers.push_back(helpers_[i]);
        areas.push_back(*tools_[i].area);
    }
    numbers_ = std::move(numbers);
    areas_ = std::move(areas);
    listTools();
}

std::vector<int> LumpSolver::thoseWhoReachSome() const {
    std::vector<int> found;
    for (const int helper : partial_) {
        const Region& reach = settings_.helpers[helper].reach->coverable;
        if (area(intersect(reach, lump_, tol_)) > tol_.area_mm2) found.push_back(helper);
    }
    return found;
}

/// Those that leave least one after another, as many as may work together.
Region LumpSolver::leftByTheBest() const {
    Region left = lump_;
    const std::size_t most = sequencesCount() ? kMostTogether : 1;
    for (std::size_t i = 0; i < most && !left.empty(); ++i) {
        Region least = left;
        for (const Candidate& tool : tools_) {
            Region rest = withoutCrumbs(subtract(left, tool.area->coverable, tol_), tol_);
            if (area(rest) < area(least)) least = std::move(rest);
        }
        left = std::move(least);
    }
    return left;
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
    for (const int node : nodes)
        areas.push_back(tools_[node].area->coverable);
    return covers(unite(areas, tol_), lump_, tol_.sliver_mm, tol_);
}

double LumpSolver::weight(const EdgeCost& cost) const {
    return weightOf(cost, settings_.options.objective);
}

double LumpSolver::changeWeight() const {
    return weight(edgeCost({}, *tools_.front().tool, settings_.machine));
}

void LumpSolver::addWay(const std::vector<int>& nodes, std::vector<PathTotals> totals) {
    LumpWay way;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const ToolAssembly& tool = *tools_[nodes[i]].tool;
        way.tools.push_back(helpers_[nodes[i]]);
        way.weight += weight(edgeCost(totals[i], tool, settings_.machine)) -
                      weight(edgeCost({}, tool, settings_.machine));
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
    for (const Helper& helper : settings_.helpers)
        fastest = std::max(fastest, helperRate(helper));
    const double least_s = fastest > 0 ? ground_.feature().volume_mm3 / fastest : 0;
    // Two tools are one change more.
    return changeWeight() + weight(machineCost(least_s, settings_.machine)) < cheapest;
}

double LumpSolver::helperRate(const Helper& helper) const {
    const CuttingData cutting =
        limitedBy(settings_.machine, *helper.tool->cuttingFor(settings_.options.material));
    return volumeRate(settings_.ground.feature(), *helper.tool, cutting);
}

/// The cheapest sequence, where it has more than one tool. A tool that reaches all comes last, so what it
/// clears after others is right whatever these reach.
void LumpSolver::weighSequences() {
    double alone = kNoEdge;
    for (const LumpWay& way : ways_)
        alone = std::min(alone, way.weight);
    offer(thoseWhoReachSome());
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
    step.least_stick_out_mm = leastStickOutMm(settings_.ground, *tools_[node].tool, tools_[node].own());
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

const ToolAssembly& SolvedLump::tool(int helper) const {
    return solver_->toolOf(helper);
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
