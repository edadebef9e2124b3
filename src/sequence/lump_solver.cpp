#include "sequence/lump_solver.h"

#include <algorithm>
#include <numeric>
#include <optional>

#include <tbb/parallel_for.h>

#include "stepmill/core/error.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// A way in over an open edge starts up to 1 mm beside the material; nothing of a lump's path goes farther
/// from it than the cutter's diameter and this [mm].
constexpr double kBesideMm = 2;

/// Where no tool reaches all of a lump: how many are asked to do it together, how many such sets are looked
/// at, and how many of those that can get their paths.
constexpr std::size_t kMostTogether = 3;
constexpr int kMostSetsSeen = 400;
constexpr std::size_t kMostSetsWeighed = 12;

}  // namespace

class LumpSolver {
  public:
    LumpSolver(const LumpSettings& settings, const Region& lump, const std::vector<Region>& standing)
        : settings_(settings), tol_(settings.ground.tolerances()), lump_(lump), standing_(standing) {
        // What stands differs from tool to tool, by its holder: it comes with the tools' areas.
        const Feature feature = lumpFeature(settings.ground.feature(), lump, {}, 0, tol_);
        solved_ = std::shared_ptr<SolvedLump>(new SolvedLump(FeatureGround(feature, tol_)));
        solved_->options_ = &settings.options;
        solved_->machine_ = &settings.machine;
        solved_->retract_z_mm_ = settings.retract_z_mm;
    }

    std::shared_ptr<const SolvedLump> solve(const std::string& held_off_id) {
        std::vector<int> whole;
        std::vector<int> partial;
        for (int i = 0; i < static_cast<int>(settings_.helpers.size()); ++i) {
            const AccessibleArea& reach = *settings_.helpers[i].reach;
            if (reach.tool_id == held_off_id) continue;
            (covers(reach.coverable, lump_, tol_.sliver_mm, tol_) ? whole : partial).push_back(i);
        }
        offer(whole);
        keepThoseWhoReachAll();
        if (!solved_->tools_.empty()) weighSingles();
        const bool sequences = settings_.options.surrogates == SurrogateRule::Sequence;
        if (solved_->ways_.empty()) {
            offer(thoseWhoReachSome(partial));
            if (sequences) weighSets();
            if (solved_->ways_.empty()) solved_->unserved_ = leftByTheBest();
        } else if (sequences && mayPayTwo()) {
            weighSequences(partial);
        }
        return solved_;
    }

  private:
    /// The area of a helper in the lump, holder clear, nothing that stands around it touched.
    AccessibleArea areaIn(int helper) const {
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
    void offer(const std::vector<int>& helpers) {
        std::vector<AccessibleArea> found(helpers.size());
        tbb::parallel_for(std::size_t{0}, helpers.size(),
                          [&](std::size_t i) { found[i] = areaIn(helpers[i]); });
        std::vector<std::pair<int, AccessibleArea>> all;
        for (const Candidate& tool : solved_->tools_)
            all.emplace_back(helperOf(tool), *tool.area);
        for (std::size_t i = 0; i < helpers.size(); ++i)
            all.emplace_back(helpers[i], std::move(found[i]));
        std::stable_sort(all.begin(), all.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        numbers_.clear();
        solved_->areas_.clear();
        for (auto& [helper, area] : all) {
            numbers_.push_back(helper);
            solved_->areas_.push_back(std::move(area));
        }
        listTools();
    }

    void listTools() {
        solved_->tools_ = usableTools(solved_->ground_.feature(), solved_->areas_, settings_.library,
                                      settings_.options, settings_.machine, tol_);
        solved_->helpers_.clear();
        solved_->ends_.clear();
        for (const Candidate& tool : solved_->tools_) {
            solved_->helpers_.push_back(helperOf(tool));
            solved_->ends_.push_back(covers(tool.area->coverable, lump_, tol_.sliver_mm, tol_));
        }
        solved_->rings_.assign(solved_->tools_.size(), nullptr);
    }

    int helperOf(const Candidate& tool) const { return numbers_[tool.area - solved_->areas_.data()]; }

    void keepThoseWhoReachAll() {
        std::vector<AccessibleArea> areas;
        std::vector<int> numbers;
        for (std::size_t i = 0; i < solved_->tools_.size(); ++i) {
            if (!solved_->ends_[i]) continue;
            numbers.push_back(solved_->helpers_[i]);
            areas.push_back(*solved_->tools_[i].area);
        }
        numbers_ = std::move(numbers);
        solved_->areas_ = std::move(areas);
        listTools();
    }

    double weigh(const EdgeCost& cost) const {
        return settings_.options.objective == Objective::Time ? cost.time_s : cost.cost;
    }

    double changeWeight() const {
        return weigh(edgeCost({}, *solved_->tools_.front().tool, settings_.machine));
    }

    void addWay(const std::vector<int>& nodes, std::vector<PathTotals> totals) {
        LumpWay way;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const ToolAssembly& tool = *solved_->tools_[nodes[i]].tool;
            way.tools.push_back(solved_->helpers_[nodes[i]]);
            way.weight += weigh(edgeCost(totals[i], tool, settings_.machine)) -
                          weigh(edgeCost({}, tool, settings_.machine));
        }
        solved_->ways_.push_back(std::move(way));
        solved_->totals_.push_back(std::move(totals));
    }

    /// The path of one after another (-1: nothing yet); nothing when there is nothing new to clear.
    std::optional<PathTotals> totalsOf(int before, int node) const {
        const Candidate* from = before < 0 ? nullptr : &solved_->tools_[before];
        const SequenceStep step =
            makePath(solved_->task(), from, solved_->tools_[node], solved_->rings_[node]);
        if (step.path.moves.empty()) return std::nullopt;
        return step.path.totals;
    }

    void makeRingsOf(const std::vector<int>& nodes) {
        tbb::parallel_for(std::size_t{0}, nodes.size(), [&](std::size_t i) {
            SharedRings& rings = solved_->rings_[nodes[i]];
            if (!rings) rings = ringsOf(solved_->task(), solved_->tools_[nodes[i]]);
        });
    }

    void weighSingles() {
        std::vector<int> nodes(solved_->tools_.size());
        std::iota(nodes.begin(), nodes.end(), 0);
        makeRingsOf(nodes);
        std::vector<std::optional<PathTotals>> totals(nodes.size());
        tbb::parallel_for(std::size_t{0}, nodes.size(),
                          [&](std::size_t i) { totals[i] = totalsOf(-1, nodes[i]); });
        for (const int node : nodes)
            if (totals[node]) addWay({node}, {*totals[node]});
    }

    /// Could two tools and their changes be cheaper than the cheapest one?
    bool mayPayTwo() const {
        double cheapest = kNoEdge;
        for (const LumpWay& way : solved_->ways_)
            cheapest = std::min(cheapest, way.weight);
        double fastest = 0;
        for (const Helper& helper : settings_.helpers)
            fastest = std::max(fastest, helperRate(helper));
        const Feature& feature = solved_->ground_.feature();
        const double least_s = fastest > 0 ? feature.volume_mm3 / fastest : 0;
        // Two tools are one change more.
        return changeWeight() + weigh(machineCost(least_s, settings_.machine)) < cheapest;
    }

    double helperRate(const Helper& helper) const {
        const CuttingData cutting =
            limitedBy(settings_.machine, *helper.tool->cuttingFor(settings_.options.material));
        return volumeRate(settings_.ground.feature(), *helper.tool, cutting);
    }

    std::vector<int> thoseWhoReachSome(const std::vector<int>& helpers) const {
        std::vector<int> found;
        for (const int helper : helpers) {
            const Region& reach = settings_.helpers[helper].reach->coverable;
            if (area(intersect(reach, lump_, tol_)) > tol_.area_mm2) found.push_back(helper);
        }
        return found;
    }

    /// The cheapest sequence, where it has more than one tool. A tool that reaches all comes last, so what it
    /// clears after others is right whatever these reach.
    void weighSequences(const std::vector<int>& partial) {
        offer(thoseWhoReachSome(partial));
        const DagResult dag = evaluateDag(solved_->task());
        solved_->rings_ = dag.rings;
        if (dag.path.size() > 1) weighInARow(dag.path);
    }

    bool weighInARow(const std::vector<int>& nodes) {
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

    bool reachAllTogether(const std::vector<int>& nodes) const {
        std::vector<Region> areas;
        for (const int node : nodes)
            areas.push_back(solved_->tools_[node].area->coverable);
        return covers(unite(areas, tol_), lump_, tol_.sliver_mm, tol_);
    }

    /// Sets of tools of which none reaches all, the smallest sets that can.
    void weighSets() {
        int seen = 0;
        std::vector<int> nodes;
        const auto extend = [&](auto& self, std::size_t size, int first) -> void {
            if (nodes.size() == size) {
                if (seen++ < kMostSetsSeen && reachAllTogether(nodes)) weighInARow(nodes);
                return;
            }
            for (int node = first; node < static_cast<int>(solved_->tools_.size()); ++node) {
                if (seen >= kMostSetsSeen || solved_->ways_.size() >= kMostSetsWeighed) return;
                nodes.push_back(node);
                self(self, size, node + 1);
                nodes.pop_back();
            }
        };
        for (std::size_t size = 2; size <= kMostTogether && solved_->ways_.empty(); ++size)
            extend(extend, size, 0);
    }

    /// Those that leave least one after another, as many as may work together.
    Region leftByTheBest() const {
        Region left = lump_;
        const std::size_t most = settings_.options.surrogates == SurrogateRule::Sequence ? kMostTogether : 1;
        for (std::size_t i = 0; i < most && !left.empty(); ++i) {
            Region least = left;
            for (const Candidate& tool : solved_->tools_) {
                Region rest = withoutCrumbs(subtract(left, tool.area->coverable, tol_), tol_);
                if (area(rest) < area(least)) least = std::move(rest);
            }
            left = std::move(least);
        }
        return left;
    }

    const LumpSettings& settings_;
    const Tolerances& tol_;
    const Region& lump_;
    const std::vector<Region>& standing_;
    std::vector<int> numbers_;  ///< helper of each of the areas
    std::shared_ptr<SolvedLump> solved_;
};

std::size_t SolvedLump::numberOf(int helper) const {
    const auto found = std::find(helpers_.begin(), helpers_.end(), helper);
    STEPMILL_CHECK(found != helpers_.end(), "only tools of a lump's ways work in it");
    return static_cast<std::size_t>(found - helpers_.begin());
}

SequenceStep SolvedLump::step(int way, std::size_t place) const {
    const std::vector<int>& tools = ways_[way].tools;
    const Candidate* before = place == 0 ? nullptr : &tools_[numberOf(tools[place - 1])];
    const std::size_t node = numberOf(tools[place]);
    return makeStep(task(), before, tools_[node], rings_[node]);
}

std::shared_ptr<const SolvedLump> solveLump(const LumpSettings& settings, const Region& lump,
                                            const std::vector<Region>& standing,
                                            const std::string& held_off_id) {
    return LumpSolver(settings, lump, standing).solve(held_off_id);
}

}  // namespace stepmill
