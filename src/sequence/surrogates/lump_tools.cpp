#include "sequence/surrogates/lump_tools.h"

#include <algorithm>

#include "sequence/dag/edge_work.h"
#include "sequence/dag/step_paths.h"
#include "stepmill/access/lumps.h"
#include "stepmill/core/error.h"
#include "stepmill/core/parallel.h"
#include "stepmill/planar/boolean.h"

namespace stepmill {
namespace {

/// An entry over an open edge starts up to 1 mm beside the material; no path of a lump goes farther from the
/// lump than the cutter's diameter and this [mm].
constexpr double kBesideMm = 2;

/// How far from a lump a cutter may come that clears it.
double reachBeyondMm(const std::vector<Surrogate>& surrogates) {
    double widest_mm = 0;
    for (const Surrogate& surrogate : surrogates)
        widest_mm = std::max(widest_mm, surrogate.tool->diameter_mm);
    return 2 * widest_mm + kBesideMm;
}

}  // namespace

LumpTools::LumpTools(std::shared_ptr<const SurrogateTools> surrogates, Region lump,
                     std::vector<Region> standing)
    : surrogates_(std::move(surrogates)),
      tol_(job().tolerances()),
      lump_(std::move(lump)),
      standing_(std::move(standing)),
      // The obstruction differs from tool to tool, by its holder: reachIn() adds it.
      ground_(lumpFeature(job().feature(), lump_, {}, 0, tol_), tol_),
      around_(within(job().around, grown(boundingBox(lump_), reachBeyondMm(surrogates_->all())), tol_)) {}

/// The reach of a surrogate in the lump, with its holder clear and nothing around the lump touched.
ToolReach LumpTools::reachIn(int surrogate) const {
    const ToolAssembly& tool = *surrogates()[surrogate].tool;
    std::vector<Region> obstruction = standing_;
    obstruction.push_back(surrogates_->obstruction(surrogate));
    const Feature feature =
        lumpFeature(job().feature(), lump_, obstruction, tool.diameter_mm + kBesideMm, tol_);
    const FeatureGround ground(feature, tol_);
    job().checkTime();
    ToolReach found = reachInLump(ground, tool, job().options.material);
    found.cutter.wider_obstruction = feature.obstruction;
    found.cutter.opens_target = false;
    return found;
}

void LumpTools::offer(const std::vector<int>& surrogates) {
    std::vector<ToolReach> found(surrogates.size());
    parallelFor(surrogates.size(), [&](std::size_t i) { found[i] = reachIn(surrogates[i]); });
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
    makeNodes();
}

void LumpTools::clear() {
    reaches_.clear();
    numbers_.clear();
    makeNodes();
}

void LumpTools::keepEnds() {
    std::vector<ToolReach> reaches;
    std::vector<int> numbers;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
        if (!ends_[i]) continue;
        numbers.push_back(surrogate_of_[i]);
        reaches.push_back(*nodes_[i].reach);
    }
    numbers_ = std::move(numbers);
    reaches_ = std::move(reaches);
    makeNodes();
}

void LumpTools::makeNodes() {
    nodes_ = usableTools(ground_.feature(), reaches_, job().library, job().options, job().machine, tol_);
    surrogate_of_.clear();
    ends_.clear();
    for (const Candidate& node : nodes_) {
        surrogate_of_.push_back(numbers_[node.reach - reaches_.data()]);
        ends_.push_back(covers(node.cleared->coverable, lump_, tol_.sliver_mm, tol_));
    }
    dropRings();
}

bool LumpTools::anyEnds() const {
    return std::find(ends_.begin(), ends_.end(), true) != ends_.end();
}

int LumpTools::nodeOf(int surrogate) const {
    const auto found = std::find(surrogate_of_.begin(), surrogate_of_.end(), surrogate);
    STEPMILL_CHECK(found != surrogate_of_.end(), "only tools of a lump's ways work in it");
    return static_cast<int>(found - surrogate_of_.begin());
}

DagTask LumpTools::task() const {
    return {ground_, nodes_, ends_, around_, job().options, job().machine, job().retract_z_mm};
}

void LumpTools::makeRings(const std::vector<int>& nodes) {
    parallelFor(nodes.size(), [&](std::size_t i) {
        job().checkTime();
        SharedRings& rings = rings_[nodes[i]];
        if (!rings && needsPaths(task())) rings = ringsOf(task(), nodes_[nodes[i]]);
    });
}

std::optional<PathTotals> LumpTools::totalsOf(int before, int node) const {
    job().checkTime();
    const Candidate* from = before == kSource ? nullptr : &nodes_[before];
    const auto work = edgeWork(task(), from, nodes_[node], rings_[node]);
    return work ? std::optional(work->totals) : std::nullopt;
}

}  // namespace stepmill
