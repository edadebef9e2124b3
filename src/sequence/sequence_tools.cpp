#include <tbb/parallel_for.h>

#include "sequence/dag/candidate.h"
#include "sequence/dag/evaluate_dag.h"
#include "sequence/dag/lower_bound.h"
#include "sequence/dag/sequence_choices.h"
#include "sequence/holder/holder_limits.h"
#include "sequence/holder/tool_areas.h"
#include "sequence/steps/residuals.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/sequence.h"

namespace stepmill {
namespace {

/// Areas of all tools. A drill of the hole's own size takes part although the area calculus turns it away.
std::vector<AccessibleArea> areasOfAllTools(const FeatureGround& ground, const ToolLibrary& library,
                                            const SequenceOptions& options) {
    const std::vector<const ToolAssembly*> tools = byFallingDiameter(library);
    std::vector<AccessibleArea> areas(tools.size());
    tbb::parallel_for(std::size_t{0}, tools.size(), [&](std::size_t i) {
        areas[i] = areaFor(ground, *tools[i], options);
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
    // z = 0 is the stock's top, so the height over it is the retract plane's z.
    const double retract_z = job.options.retract_mm > 0 ? job.options.retract_mm : job.machine.safe_height_mm;
    const auto made = std::make_shared<SequenceChoices>(FeatureGround(feature, job.tol), job.options,
                                                        job.machine, job.library, retract_z);
    const FeatureGround& ground = made->ground;
    ToolSequence sequence;
    sequence.feature_id = feature.id;
    sequence.floor_z_mm = feature.floor_z_mm;
    made->areas = areasOfAllTools(ground, job.library, job.options);
    const auto usable = [&] {
        return usableTools(feature, made->areas, job.library, job.options, job.machine, job.tol);
    };
    const std::vector<AccessibleArea> unlimited = made->areas;
    // The finder outlives this call with the choices: it must look at their copy of the options.
    const Job kept{job.library, job.machine, made->options, job.tol};
    Admission admission = admitHelped(ground, kept, retract_z, mostCovered(usable()), unlimited);
    made->areas = std::move(admission.areas);
    made->finder = std::move(admission.finder);
    admitLimited(ground, job.library, mostCovered(usable()), made->areas);
    sequence.tools = made->areas;
    made->tools = usable();
    made->withheld = withheldFrom(ground, job.library, mostCovered(made->tools), unlimited);
    if (may_end_higher) {
        const double known_mm3 = mostCovered(made->tools) * feature.depth_mm();
        if (const auto reached = shallower(ground, job.library, unlimited, known_mm3)) {
            ToolSequence above = sequenceAbove(feature, *reached, job);
            if (!above.steps.empty()) return above;
        }
    }
    made->ends = endTools(feature, made->tools, job.tol);
    if (!made->tools.empty()) made->dag = evaluateDag(made->task());
    sequence.pruned_edges = made->dag.pruned;
    if (made->dag.path.empty()) {
        sequence.residual.push_back(wholeFeature(ground, sequence.tools, job.library));
        return sequence;
    }
    made->take(0, sequence);
    const TimeBounds bounds = timeBounds(feature, made->tools, made->ends, job.machine, job.tol);
    sequence.lower_bound_s = bounds.with_changes_s;
    sequence.cutting_bound_s = bounds.cutting_s;
    sequence.residual = made->left();
    sequence.choices = made;
    return sequence;
}

}  // namespace

ToolSequence sequenceTools(const Feature& feature, const ToolLibrary& library, const Machine& machine,
                           const SequenceOptions& options, const Tolerances& tol) {
    return sequenceTo(feature, {library, machine, options, tol}, true);
}

}  // namespace stepmill
