// The paths of tools after one another: those that edges are weighed by, and those that are run.

#include "sequence/dag/step_paths.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/spotting.h"
#include "stepmill/toolpath/adaptive_cutting.h"
#include "stepmill/toolpath/cut_feeds.h"

namespace stepmill {
namespace {

/// What a mill clears in one go: of the whole depth what the tool before it has left, or, where that was a
/// drill that stayed over the floor, what is beside it and then all below.
struct Stretch {
    double top_z_mm = 0;
    double floor_z_mm = 0;
    const Candidate* after = nullptr;
};

std::vector<Stretch> stretchesOf(const DagTask& task, const Candidate* m) {
    const Feature& feature = task.ground.feature();
    const double drilled_to_mm =
        m != nullptr && m->predrills ? preDrilledToZ(feature, *m->tool) : feature.floor_z_mm;
    if (drilled_to_mm <= feature.floor_z_mm) return {{feature.top_z_mm, feature.floor_z_mm, m}};
    return {{feature.top_z_mm, drilled_to_mm, m}, {drilled_to_mm, feature.floor_z_mm, nullptr}};
}

/// The clearing task of edge (m, n): the area that n sweeps after m.
ClearingTask clearingTask(const DagTask& task, const Candidate& n, const Stretch& stretch,
                          const DecomposedArea& decomposed, Pattern pattern, const SharedRings& rings) {
    const Feature& feature = task.ground.feature();
    ClearingTask clearing = clearingTaskOf(feature, task.around, *n.own, task.retract_z_mm);
    clearing.entries = n.own->entries;
    clearing.slot_middles = n.own->slot_middles;
    clearing.in_slot =
        stretch.after != nullptr && !stretch.after->predrills && !stretch.after->own->slot_middles.empty();
    clearing.centres = decomposed.centres;
    clearing.cleared_centres = decomposed.cleared_centres;
    // The plan may set the tool out shorter than the library allows: it takes the shortest stick-out that
    // works.
    addHolder(feature, *n.tool, clearing);
    // Below where a hole was drilled first its own walls stand over the stretch.
    if (stretch.top_z_mm < feature.top_z_mm) clearing.stands_above.reset();
    clearing.top_z_mm = stretch.top_z_mm;
    clearing.floor_z_mm = stretch.floor_z_mm;
    clearing.pattern = pattern;
    clearing.patterns = task.options.patterns;
    clearing.rings = rings;
    return clearing;
}

/// The step without its path.
SequenceStep stepOf(const DagTask& task, const Stretch& stretch, const Candidate& n) {
    SequenceStep step;
    step.tool_id = n.tool->id;
    step.speed_rpm = n.cutting.speed_rpm;
    step.area =
        decomposedArea(task.ground, stretch.after != nullptr ? stretch.after->cleared : nullptr, *n.own);
    step.leaves.floors_mm = stretch.floor_z_mm - task.ground.feature().floor_z_mm;
    return step;
}

Toolpath pathBy(Pattern pattern, const DagTask& task, const Candidate& n, const Stretch& stretch,
                const DecomposedArea& decomposed, const SharedRings& rings) {
    if (decomposed.centres.empty()) return {};
    return clearArea(clearingTask(task, n, stretch, decomposed, pattern, rings), *n.tool, n.cutting,
                     task.machine, task.ground.tolerances());
}

SequenceStep drilledBy(const DagTask& task, const Candidate& n) {
    const Feature& feature = task.ground.feature();
    if (n.spots) return spotStep(feature, *n.tool, n.cutting, task.retract_z_mm, task.machine);
    return n.predrills ? preDrillStep(feature, *n.tool, n.cutting, task.retract_z_mm, task.machine,
                                      task.ground.tolerances())
                       : drillStep(feature, *n.tool, n.cutting, task.retract_z_mm, task.machine);
}

SharedRings ringsBy(Pattern pattern, const DagTask& task, const Candidate& n, const Stretch& stretch) {
    return makeRings(clearingTask(task, n, stretch, {}, pattern, nullptr), *n.tool, n.cutting,
                     task.ground.tolerances());
}

/// Patterns that take so much longer than the quickest at the cutting feed are not weighed by what they cut:
/// a path that is a full slot for a third of its length takes about that.
constexpr double kFedRivalShare = 0.25;

double weightOf(const DagTask& task, const Candidate& n, const PathTotals& totals) {
    return weightOf(edgeCost(totals, *n.tool, task.machine), task.options.objective);
}

/// Paths over what stands in the feature when the stretch begins, at feeds by what they cut.
class AsFed {
  public:
    /// \pre the material's cutting is known
    AsFed(const DagTask& task, const Candidate& n, const Stretch& stretch)
        : task_(task), n_(n), ground_(standing(task, stretch), stretch.top_z_mm) {}

    /// Nothing where nothing is known of what the tool's cuts ask for.
    std::optional<PathTotals> operator()(const Toolpath& path) const {
        const std::optional<CuttingFacts> facts = factsOf(path);
        if (!facts) return std::nullopt;
        return measure(withCutFeeds(path, ground_, CuttingModel(*facts)).path, task_.machine);
    }

  private:
    static Region standing(const DagTask& task, const Stretch& stretch) {
        const Region& target = task.ground.feature().target;
        if (stretch.after == nullptr || stretch.after->cleared == nullptr) return target;
        return subtract(target, stretch.after->cleared->accessible, task.ground.tolerances());
    }

    std::optional<CuttingFacts> factsOf(const Toolpath& path) const {
        std::optional<CuttingData> cutting = n_.cutting;
        if (path.engagement_rad > 0)
            cutting = adaptiveCutting(*n_.tool, n_.cutting, path.depths * path.step_down_mm);
        if (!cutting) return std::nullopt;
        return cuttingFacts(*n_.tool, *cutting, *task_.options.cut_material, task_.machine);
    }

    const DagTask& task_;
    const Candidate& n_;
    CutGround ground_;
};

/// What a path cuts decides how fast it is fed: its times are those.
void takeTotalsAsFed(const DagTask& task, const Candidate& n, const Stretch& stretch, Toolpath& path) {
    if (!task.options.cut_material || path.moves.empty()) return;
    if (const std::optional<PathTotals> totals = AsFed(task, n, stretch)(path)) path.totals = *totals;
}

/// A first tool's path, or that of one pattern for all regions where its cuts are so much less wide that it
/// is quicker: an open face is entered through a full slot only where all ways round take longer.
Toolpath quickestAsFed(Toolpath path, const DagTask& task, const Candidate& n, const Stretch& stretch,
                       const DecomposedArea& decomposed, const SharedRings& rings) {
    if (!task.options.cut_material || stretch.after != nullptr) return path;
    const std::set<Pattern> rivals = rivalPatterns(path, kFedRivalShare);
    if (rivals.empty()) return path;
    const AsFed as_fed(task, n, stretch);
    std::vector<FedPattern> compared;
    double least = kNoEdge;
    const auto compare = [&](Toolpath other) {
        if (other.moves.empty()) return;
        const std::optional<PathTotals> totals = as_fed(other);
        if (!totals) return;
        const double weight = weightOf(task, n, *totals);
        compared.insert(weight < least ? compared.begin() : compared.end(),
                        {other.pattern, totals->motion_time_s});
        if (weight >= least) return;
        least = weight;
        path = std::move(other);
    };
    compare(path);
    if (compared.empty()) return path;
    for (const Pattern pattern : rivals)
        compare(pathBy(pattern, task, n, stretch, decomposed, rings));
    std::stable_sort(compared.begin() + 1, compared.end(),
                     [](const FedPattern& a, const FedPattern& b) { return a.time_s < b.time_s; });
    path.as_fed = std::move(compared);
    return path;
}

/// A path of constant engagement, or that of the other patterns where it is quicker when both are fed by what
/// they cut.
Toolpath adaptiveAsFed(Toolpath adaptive, const DagTask& task, const Candidate& n, const Stretch& stretch,
                       const DecomposedArea& decomposed, const SharedRings& rings) {
    const std::vector<Pattern>& asked = task.options.patterns;
    if (!task.options.cut_material || asked == std::vector<Pattern>{Pattern::Adaptive}) return adaptive;
    ClearingTask clearing = clearingTask(task, n, stretch, decomposed, task.options.pattern, rings);
    clearing.patterns = notAdaptive(asked);
    Toolpath other = clearArea(clearing, *n.tool, n.cutting, task.machine, task.ground.tolerances());
    if (other.moves.empty()) return adaptive;
    other = quickestAsFed(std::move(other), task, n, stretch, decomposed, rings);
    const AsFed as_fed(task, n, stretch);
    const std::optional<PathTotals> of_adaptive = as_fed(adaptive);
    const std::optional<PathTotals> of_other = as_fed(other);
    const bool stays =
        !of_adaptive || !of_other || weightOf(task, n, *of_adaptive) <= weightOf(task, n, *of_other);
    return stays ? adaptive : other;
}

/// Each region takes its own quickest pattern; the links between the regions may cost more than that saves.
Toolpath quickestPath(const DagTask& task, const Candidate& n, const Stretch& stretch,
                      const DecomposedArea& decomposed) {
    if (decomposed.centres.empty()) return {};
    // Rings for any pattern have those of the weighed one among them.
    const SharedRings rings = ringsBy(task.options.pattern, task, n, stretch);
    Toolpath path = pathBy(task.options.pattern, task, n, stretch, decomposed, rings);
    // Where every region took the weighed pattern this is its path.
    const bool has_others = std::any_of(
        path.regions.begin(), path.regions.end(),
        [](const RegionPatterns& region) { return region.weighed.front().pattern != kWeighedPattern; });
    const bool may_be_weighed =
        task.options.pattern == Pattern::Best && isAmong(task.options.patterns, kWeighedPattern);
    if (has_others && may_be_weighed) {
        Toolpath weighed = pathBy(kWeighedPattern, task, n, stretch, decomposed, rings);
        if (weightOf(task, n, weighed.totals) < weightOf(task, n, path.totals)) path = std::move(weighed);
    }
    return path.engagement_rad > 0 ? adaptiveAsFed(std::move(path), task, n, stretch, decomposed, rings)
                                   : quickestAsFed(std::move(path), task, n, stretch, decomposed, rings);
}

double adaptiveSpeedRpm(const CuttingData& cutting) {
    const bool own = cutting.adaptive && cutting.adaptive->speed_rpm > 0;
    return own ? cutting.adaptive->speed_rpm : cutting.speed_rpm;
}

/// The step of one stretch, proved.
SequenceStep milledBy(const DagTask& task, const Candidate* m, const Candidate& n, const Stretch& stretch) {
    const Feature& feature = task.ground.feature();
    const Tolerances& tol = task.ground.tolerances();
    SequenceStep step = stepOf(task, stretch, n);
    const ClearingTask clearing = clearingTask(task, n, stretch, step.area, task.options.pattern, nullptr);
    step.path = withRapidsOverVoids(quickestPath(task, n, stretch, step.area), clearing, n.tool->radius_mm(),
                                    task.machine, tol);
    takeTotalsAsFed(task, n, stretch, step.path);
    if (step.path.engagement_rad > 0) step.speed_rpm = adaptiveSpeedRpm(n.cutting);
    const bool facing = feature.feature_class == FeatureClass::Face;
    step.role = m != nullptr ? Role::Rest : facing ? Role::Face : Role::Rough;
    step.proof = prove(step.path, clearing, n.tool->radius_mm(), tol);
    if (step.proof.least_clearance_mm < -tol.gouge_mm) {
        throw Error(ErrorCode::Internal, feature.id,
                    fmt::format("the path of tool {} would cut {:.4f} mm into what must stay", n.tool->id,
                                -step.proof.least_clearance_mm));
    }
    return step;
}

}  // namespace

SharedRings ringsOf(const DagTask& task, const Candidate& tool) {
    if (!tool.mills()) return nullptr;
    return ringsBy(kWeighedPattern, task, tool, stretchesOf(task, nullptr).front());
}

bool isWeighedAsFed(const DagTask& task, const Candidate* m) {
    return m != nullptr || task.ground.walledIn();
}

std::vector<SequenceStep> makePaths(const DagTask& task, const Candidate* m, const Candidate& n,
                                    const SharedRings& rings) {
    if (!n.mills()) return {drilledBy(task, n)};
    std::vector<SequenceStep> steps;
    for (const Stretch& stretch : stretchesOf(task, m)) {
        SequenceStep step = stepOf(task, stretch, n);
        step.path = pathBy(kWeighedPattern, task, n, stretch, step.area, rings);
        if (step.path.moves.empty()) continue;
        if (isWeighedAsFed(task, m)) takeTotalsAsFed(task, n, stretch, step.path);
        steps.push_back(std::move(step));
    }
    return steps;
}

std::vector<SequenceStep> makeSteps(const DagTask& task, const Candidate* m, const Candidate& n) {
    if (!n.mills()) return {drilledBy(task, n)};
    std::vector<SequenceStep> steps;
    const std::vector<Stretch> stretches = stretchesOf(task, m);
    for (const Stretch& stretch : stretches) {
        SequenceStep step = milledBy(task, m, n, stretch);
        if (stretches.size() == 1 || !step.path.moves.empty()) steps.push_back(std::move(step));
    }
    return steps;
}

SequenceStep makeStep(const DagTask& task, const Candidate* m, const Candidate& n) {
    return makeSteps(task, m, n).front();
}

}  // namespace stepmill
