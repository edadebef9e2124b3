#include "sequence/surrogates/admission.h"

#include <algorithm>

#include "sequence/dag/candidate.h"
#include "sequence/holder/holder_limits.h"
#include "sequence/holder/tool_areas.h"
#include "sequence/surrogates/held_off.h"
#include "stepmill/core/parallel.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/sequence/drilling.h"
#include "stepmill/sequence/spotting.h"

namespace stepmill {
namespace {

/// How often ground that no few tools can clear together is given up before tools are turned down for it.
constexpr int kMostGivenUp = 3;

/// What the area calculus does not know of tools for holes: whether a drill fits the hole or makes room for a
/// mill, whether a spot drill starts it.
void checkHoleTool(const SequenceJob& job, const ToolAssembly& tool, ToolReach& reach) {
    if (tool.cuttingFor(job.options.material) == nullptr) return;
    if (tool.isSpot() && spotFits(job.feature(), tool)) reach.use = Unhindered{};
    if (!tool.isDrill()) return;
    DrillCheck check = drillCheck(job.feature(), tool, job.tolerances());
    if (preDrills(job.feature(), tool, job.tolerances()))
        reach.cutter = preDrilledArea(job.feature(), tool, job.tolerances());
    if (check.fits || !reach.cutter.coverable.empty()) {
        reach.use = Unhindered{};
    } else if (check.excluded) {
        reach.use = std::move(*check.excluded);
    } else if (reach.exclusion() == nullptr) {
        reach.use = Exclusion{ExclusionReason::WrongType, "is wider than the hole"};
    }
}

/// Tools with surrogates that could clear more than every tool without, those that could clear most first.
std::vector<std::size_t> byWhatTheyCouldClear(const Admission& admission, double enough_mm2) {
    const auto could_mm2 = [&](std::size_t i) { return admission.reaches[i].cleared().coverable_area_mm2; };
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < admission.reaches.size(); ++i)
        if (admission.reaches[i].surrogates() != nullptr && could_mm2(i) > enough_mm2) found.push_back(i);
    std::stable_sort(found.begin(), found.end(),
                     [&](std::size_t a, std::size_t b) { return could_mm2(a) > could_mm2(b); });
    return found;
}

/// Turns down tools that could clear more than every other, but with a lump nobody can do: the feature must
/// not end with one of them. The first whose lumps can all be done ends the search: tools that clear less end
/// no feature, and of those that clear the same the DAG leaves out the edges that nobody can do.
/// \return  what nobody can do of the lumps of those turned down
Region turnDownUnserved(const std::vector<ToolReach>& alone, double enough_mm2, const Tolerances& tol,
                        Admission& admission) {
    std::vector<Region> unserved;
    for (const std::size_t i : byWhatTheyCouldClear(admission, enough_mm2)) {
        const std::size_t before = unserved.size();
        for (const auto& lump : admission.finder->lumpsOf(nullptr, admission.reaches[i]))
            if (!lump->servable()) unserved.push_back(lump->unserved());
        if (unserved.size() == before) break;
        admission.reaches[i] = alone[i];
    }
    return unserved.empty() ? Region{} : unite(unserved, tol);
}

Admission admitWithSurrogates(const std::shared_ptr<const SequenceJob>& job,
                              const std::vector<ToolReach>& alone, const HeldOffTools& held_off) {
    const Tolerances& tol = job->tolerances();
    const double same_mm2 = sameArea(job->feature(), tol);
    const double enough_mm2 = mostUsableMm2(*job, alone) + same_mm2;
    Admission best;
    Region given_up;
    for (int round = 0; round <= kMostGivenUp; ++round) {
        Admission admission{withSurrogates(*job, held_off, given_up, alone), nullptr};
        admission.finder = std::make_shared<const SurrogateFinder>(job, admission.reaches);
        const double could_mm2 = admission.mostCoveredMm2();
        // What was given up does not come back, so no later round can do better than this.
        if (round > 0 && could_mm2 <= best.mostCoveredMm2() + same_mm2) break;
        const Region unserved = turnDownUnserved(alone, enough_mm2, tol, admission);
        if (round == 0 || admission.mostCoveredMm2() > best.mostCoveredMm2() + same_mm2)
            best = std::move(admission);
        if (unserved.empty() || best.mostCoveredMm2() >= could_mm2 - same_mm2) break;
        given_up = given_up.empty() ? unserved : unite(given_up, unserved, tol);
    }
    return best;
}

/// Tools that nobody stands in for do what their holder allows: a wide one that is kept off a corner is the
/// quickest for all the rest of a large pocket.
void limitTheRest(const HeldOffTools& held_off, std::vector<ToolReach>& reaches) {
    for (std::size_t i = 0; i < reaches.size(); ++i)
        if (isHeldOff(reaches[i]) && held_off.own[i]) reaches[i] = limitedTo(reaches[i], *held_off.own[i]);
}

}  // namespace

double Admission::mostCoveredMm2() const {
    double most_mm2 = 0;
    for (const ToolReach& reach : reaches)
        if (reach.exclusion() == nullptr) most_mm2 = std::max(most_mm2, reach.cleared().coverable_area_mm2);
    return most_mm2;
}

std::vector<ToolReach> reachesOfAllTools(const SequenceJob& job) {
    const std::vector<const ToolAssembly*> tools = byFallingDiameter(job.library);
    std::vector<ToolReach> reaches(tools.size());
    parallelFor(tools.size(), [&](std::size_t i) {
        job.checkTime();
        reaches[i] = reachFor(job.ground, *tools[i], job.options);
        checkHoleTool(job, *tools[i], reaches[i]);
    });
    return reaches;
}

double mostUsableMm2(const SequenceJob& job, const std::vector<ToolReach>& reaches) {
    double most_mm2 = 0;
    for (const Candidate& tool :
         usableTools(job.feature(), reaches, job.library, job.options, job.machine, job.tolerances()))
        most_mm2 = std::max(most_mm2, tool.coverable_mm2);
    return most_mm2;
}

Admission admitTools(const std::shared_ptr<const SequenceJob>& job, const std::vector<ToolReach>& alone) {
    const HeldOffTools held_off = heldOffTools(*job, alone);
    Admission admission = admitWithSurrogates(job, alone, held_off);
    limitTheRest(held_off, admission.reaches);
    return admission;
}

}  // namespace stepmill
