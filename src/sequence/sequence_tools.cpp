#include <tbb/parallel_for.h>

#include "sequence/candidate.h"
#include "sequence/drilling.h"
#include "sequence/evaluate_dag.h"
#include "sequence/holder_limits.h"
#include "sequence/lower_bound.h"
#include "sequence/residuals.h"
#include "sequence/surrogates.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {
namespace {

/// Areas of all tools. A drill of the hole's own size takes part although the area calculus turns it away.
std::vector<AccessibleArea> areasOfAllTools(const FeatureGround& ground, const ToolLibrary& library,
                                            const SequenceOptions& options) {
    const std::vector<const ToolAssembly*> tools = byFallingDiameter(library);
    std::vector<AccessibleArea> areas(tools.size());
    tbb::parallel_for(std::size_t{0}, tools.size(), [&](std::size_t i) {
        areas[i] = accessibleArea(ground, *tools[i], options.material);
        if (!tools[i]->isDrill() || tools[i]->cuttingFor(options.material) == nullptr) return;
        const DrillCheck check = drillCheck(ground.feature(), *tools[i], ground.tolerances());
        if (check.fits) {
            areas[i].excluded.reset();
        } else if (check.excluded) {
            areas[i].excluded = check.excluded;
        } else if (!areas[i].excluded) {
            areas[i].excluded = Exclusion{ExclusionReason::WrongType, "is wider than the hole"};
        }
    });
    return areas;
}

/// Every tool's step and after it those of its surrogates.
std::vector<SequenceStep> makeSteps(const DagTask& task, const DagResult& dag) {
    const std::vector<int>& path = dag.path;
    std::vector<std::vector<SequenceStep>> steps(path.size());
    tbb::parallel_for(std::size_t{0}, path.size(), [&](std::size_t i) {
        const Candidate* before = i == 0 ? nullptr : &task.tools[path[i - 1]];
        steps[i].push_back(makeStep(task, before, task.tools[path[i]], dag.rings[path[i]]));
        if (task.surrogates == nullptr) return;
        const int next = i + 1 < path.size() ? path[i + 1] : static_cast<int>(task.tools.size());
        for (SequenceStep& step : helpSteps(dag.help[i], next, *task.surrogates, task.tools))
            steps[i].push_back(std::move(step));
    });
    std::vector<SequenceStep> all;
    for (std::vector<SequenceStep>& of_edge : steps)
        std::move(of_edge.begin(), of_edge.end(), std::back_inserter(all));
    return all;
}

double mostCovered(const std::vector<Candidate>& tools) {
    double most_mm2 = 0;
    for (const Candidate& tool : tools)
        most_mm2 = std::max(most_mm2, tool.coverable_mm2);
    return most_mm2;
}

struct Job {
    const ToolLibrary& library;
    const Machine& machine;
    const SequenceOptions& options;
    const Tolerances& tol;
};

void addUp(const Job& job, ToolSequence& sequence) {
    std::string last;
    for (const SequenceStep& step : sequence.steps) {
        const ToolAssembly& tool = job.library.tool(step.tool_id);
        const EdgeCost cost = edgeCost(step.path.totals, tool, job.machine);
        const EdgeCost change = edgeCost({}, tool, job.machine);
        const bool stays = step.tool_id == last;
        sequence.time_s += cost.time_s - (stays ? change.time_s : 0);
        sequence.cost += cost.cost - (stays ? change.cost : 0);
        last = step.tool_id;
    }
}

bool hasSurrogates(const AccessibleArea& area) {
    return area.clear_of_holder != nullptr;
}

/// How often ground that no few tools can clear together is given up before tools are turned down for it.
constexpr int kMostGivenUp = 3;

/// The lumps of a tool that could clear more than every tool without surrogates; none of other tools.
Lumps lumpsThatMatter(const SurrogateFinder& finder, const AccessibleArea& area, double enough_mm2) {
    if (!hasSurrogates(area) || area.coverable_area_mm2 <= enough_mm2) return {};
    return finder.lumpsOf(nullptr, area);
}

/// What nobody can do of them.
Region unservedIn(const SurrogateFinder& finder, const std::vector<AccessibleArea>& areas, double enough_mm2,
                  const Tolerances& tol) {
    std::vector<Lumps> lumps(areas.size());
    tbb::parallel_for(std::size_t{0}, areas.size(),
                      [&](std::size_t i) { lumps[i] = lumpsThatMatter(finder, areas[i], enough_mm2); });
    std::vector<Region> unserved;
    for (const Lumps& of_tool : lumps)
        for (const auto& lump : of_tool)
            if (!lump->servable()) unserved.push_back(lump->unserved());
    return unserved.empty() ? Region{} : unite(unserved, tol);
}

/// Turns down tools that could clear more than every other, but with a lump nobody can do: the feature must
/// not end with one of them.
void turnDownUnserved(const SurrogateFinder& finder, double enough_mm2,
                      const std::vector<AccessibleArea>& before, std::vector<AccessibleArea>& areas) {
    tbb::parallel_for(std::size_t{0}, areas.size(), [&](std::size_t i) {
        const Lumps lumps = lumpsThatMatter(finder, areas[i], enough_mm2);
        const bool served =
            std::all_of(lumps.begin(), lumps.end(), [](const auto& lump) { return lump->servable(); });
        if (!served) areas[i] = before[i];
    });
}

/// The tools that take part, and who helps those with surrogates. The finder points into the areas.
struct Admission {
    std::vector<AccessibleArea> areas;
    std::unique_ptr<SurrogateFinder> finder;

    double mostCoveredMm2() const {
        double most_mm2 = 0;
        for (const AccessibleArea& area : areas)
            if (!area.excluded) most_mm2 = std::max(most_mm2, area.coverable_area_mm2);
        return most_mm2;
    }
};

/// Lets tools with surrogates take part. Where some of their ground is too much for the few tools that may
/// work in a lump, it is given up if the rest is then more than without the tools that have it.
Admission admitHelped(const FeatureGround& ground, const Job& job, double retract_z_mm, double free_mm2,
                      const std::vector<AccessibleArea>& areas) {
    const double same_mm2 = sameArea(ground.feature(), job.tol);
    const double enough_mm2 = free_mm2 + same_mm2;
    const HeldOffTools held_off = heldOffTools(ground, job.library, areas);
    Admission best;
    Region given_up;
    for (int round = 0; round <= kMostGivenUp; ++round) {
        Admission admission{areas, nullptr};
        admitWithSurrogates(ground, held_off, given_up, admission.areas);
        admission.finder = std::make_unique<SurrogateFinder>(ground, admission.areas, job.library,
                                                             job.options, job.machine, retract_z_mm);
        const double could_mm2 = admission.mostCoveredMm2();
        // What was given up does not come back, so no later round can do better than this.
        if (round > 0 && could_mm2 <= best.mostCoveredMm2() + same_mm2) break;
        const Region unserved = unservedIn(*admission.finder, admission.areas, enough_mm2, job.tol);
        turnDownUnserved(*admission.finder, enough_mm2, areas, admission.areas);
        if (round == 0 || admission.mostCoveredMm2() > best.mostCoveredMm2() + same_mm2)
            best = std::move(admission);
        if (unserved.empty() || best.mostCoveredMm2() >= could_mm2 - same_mm2) break;
        given_up = given_up.empty() ? unserved : unite(given_up, unserved, job.tol);
    }
    return best;
}

ToolSequence sequenceTo(const Feature& feature, const Job& job, bool may_end_higher);

/// The steps down to where tools reach, and the rest as residual.
ToolSequence sequenceAbove(const Feature& feature, const Shallower& reached, const Job& job) {
    ToolSequence sequence = sequenceTo(withFloor(feature, reached.floor_z_mm), job, false);
    sequence.residual.push_back(belowReach(feature, reached));
    return sequence;
}

ToolSequence sequenceTo(const Feature& feature, const Job& job, bool may_end_higher) {
    const FeatureGround ground(feature, job.tol);
    ToolSequence sequence;
    sequence.feature_id = feature.id;
    sequence.floor_z_mm = feature.floor_z_mm;
    sequence.tools = areasOfAllTools(ground, job.library, job.options);
    const auto usable = [&] {
        return usableTools(feature, sequence.tools, job.library, job.options, job.machine, job.tol);
    };
    // z = 0 is the stock's top, so the height over it is the retract plane's z.
    const double retract_z = job.options.retract_mm > 0 ? job.options.retract_mm : job.machine.safe_height_mm;
    const std::vector<AccessibleArea> unlimited = sequence.tools;
    const double free_mm2 = mostCovered(usable());
    Admission admission = admitHelped(ground, job, retract_z, free_mm2, unlimited);
    sequence.tools = std::move(admission.areas);
    admitLimited(ground, job.library, mostCovered(usable()), sequence.tools);
    const std::vector<Candidate> tools = usable();
    const std::optional<Withheld> withheld = withheldFrom(ground, job.library, mostCovered(tools), unlimited);
    if (may_end_higher) {
        const double known_mm3 = mostCovered(tools) * feature.depth_mm();
        if (const auto reached = shallower(ground, job.library, unlimited, known_mm3)) {
            ToolSequence above = sequenceAbove(feature, *reached, job);
            if (!above.steps.empty()) return above;
        }
    }
    if (tools.empty()) {
        sequence.residual.push_back(wholeFeature(ground, sequence.tools, job.library));
        return sequence;
    }
    const std::vector<bool> ends = endTools(feature, tools, job.tol);
    const DagTask task{ground, tools, ends, job.options, job.machine, retract_z, admission.finder.get()};
    const DagResult dag = evaluateDag(task);
    sequence.edges = dag.edges;
    sequence.pruned_edges = dag.pruned;
    if (dag.path.empty()) {
        sequence.residual.push_back(wholeFeature(ground, sequence.tools, job.library));
        return sequence;
    }
    sequence.steps = makeSteps(task, dag);
    addUp(job, sequence);
    const TimeBounds bounds = timeBounds(feature, tools, ends, job.machine, job.tol);
    sequence.lower_bound_s = bounds.with_changes_s;
    sequence.cutting_bound_s = bounds.cutting_s;
    std::vector<const Candidate*> used;
    for (const int index : dag.path)
        used.push_back(&tools[index]);
    sequence.residual = leftOver(ground, used, withheld);
    return sequence;
}

}  // namespace

ToolSequence sequenceTools(const Feature& feature, const ToolLibrary& library, const Machine& machine,
                           const SequenceOptions& options, const Tolerances& tol) {
    return sequenceTo(feature, {library, machine, options, tol}, true);
}

}  // namespace stepmill
