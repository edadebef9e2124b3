// Plans again with other tools until cycle times are kept [Tripathi2005, 'Changes in cycle time', step 4].

#include <algorithm>
#include <exception>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "stepmill/core/units.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/plan/plan.h"
#include "stepmill/plan/warning_order.h"
#include "stepmill/sequence/machine_limits.h"

namespace stepmill {
namespace {

/// So many features are tried with a wider tool, and so many tools are tried to do without, for each time.
constexpr std::size_t kMostDiameterTrials = 4;
constexpr std::size_t kMostSequenceTrials = 8;
/// What gains no more is no gain [s].
constexpr double kNoGainS = 0.05;
/// No cut is asked to take less than this share of its time: wider tools than that asks for are none.
constexpr double kLeastTimeShare = 0.05;

/// How much longer than asked the plan takes where its fastest pace is too slow.
double overS(const Plan& plan) {
    double over_s = 0;
    for (const CycleOutcome& outcome : plan.cycle.outcomes)
        if (!outcome.isMet() && outcome.isTooLong()) over_s += outcome.time_s - outcome.target.time_s;
    return over_s;
}

/// An operation that a cycle time is for, with the band that it cuts.
struct CutInScope {
    const PlannedFeature* planned = nullptr;
    const Operation* operation = nullptr;
};

/// Clearing operations of features that this time is for, and no narrower one.
std::vector<CutInScope> cutsOf(const Plan& plan, const std::string& of) {
    std::set<std::string> asked;
    for (const CycleTarget& target : plan.request.cycle_times)
        asked.insert(target.of);
    std::vector<CutInScope> cuts;
    for (const PlannedSetup& setup : plan.setups) {
        std::map<std::string, const PlannedFeature*> bands;
        for (const PlannedFeature& planned : setup.features)
            bands[planned.feature.id] = &planned;
        for (const Operation& operation : setup.operations) {
            const auto band = bands.find(operation.feature_id);
            if (band == bands.end() || !isClearing(operation.role)) continue;
            const std::string& whole = wholeOf(band->second->feature);
            const std::string& narrowest = asked.count(whole) > 0            ? whole
                                           : asked.count(setup.setup.id) > 0 ? setup.setup.id
                                                                             : std::string();
            if (narrowest == of) cuts.push_back({band->second, &operation});
        }
    }
    return cuts;
}

/// A trial: what it asks for, and how it will be told.
struct CycleTrial {
    CycleStep step;
    PlanRequest request;
};

CycleStep stepFor(CycleWay way, const CycleOutcome& outcome) {
    CycleStep step;
    step.way = way;
    step.of = outcome.target.of;
    step.before_s = outcome.time_s;
    return step;
}

/// What begins the feature, and how wide and long it is.
struct FirstCut {
    const PlannedFeature* planned = nullptr;
    const ToolAssembly* tool = nullptr;
    WiderCut cut;
    double time_s = 0;
};

std::vector<FirstCut> firstCuts(const Plan& plan, const CycleOutcome& outcome) {
    const std::vector<CutInScope> cuts = cutsOf(plan, outcome.target.of);
    double all_s = 0;
    for (const CutInScope& one : cuts)
        all_s += one.operation->path.totals.feed_time_s;
    // What has to be saved is saved by all of them alike.
    const double share =
        std::max(kLeastTimeShare, 1 - (outcome.time_s - outcome.target.time_s) / std::max(all_s, kNoGainS));
    std::vector<FirstCut> first;
    for (const CutInScope& one : cuts) {
        const Operation& operation = *one.operation;
        const PathTotals& totals = operation.path.totals;
        const bool begins = operation.role == Role::Face || operation.role == Role::Rough;
        const double area_mm2 = operation.even_length_mm * operation.path.step_over_mm;
        if (!begins || area_mm2 <= 0 || totals.feed_time_s <= 0) continue;
        const Vec2 sizes = boundingBox(one.planned->feature.target).sizes();
        first.push_back(
            {one.planned, &plan.library.tool(operation.tool_id),
             WiderCut{area_mm2, share * totals.feed_time_s,
                      totals.cut_length_mm / totals.feed_time_s * kSecondsPerMinute, sizes.minCoeff()},
             totals.feed_time_s});
    }
    std::stable_sort(first.begin(), first.end(),
                     [](const FirstCut& a, const FirstCut& b) { return a.time_s > b.time_s; });
    return first;
}

/// Mills wider than the one that begins the feature that can be used there.
std::vector<AvailableCutter> widerThan(const FirstCut& first, const Plan& plan, const ToolLibrary& library) {
    std::vector<AvailableCutter> wider;
    for (const ToolReach& reach : first.planned->sequence.tools) {
        const ToolAssembly& tool = library.tool(reach.tool_id);
        const CuttingData* cutting = tool.cuttingFor(plan.material);
        const bool mills = cutting != nullptr && !tool.isForHoles() && reach.exclusion() == nullptr;
        if (!mills || tool.diameter_mm <= first.tool->diameter_mm) continue;
        // clearArea() steps over no more than the radius.
        wider.push_back({tool.diameter_mm, std::min(cutting->step_over_mm, tool.radius_mm())});
    }
    return wider;
}

/// A wider tool for each of the longest first cuts.
std::vector<CycleTrial> diameterTrials(const PlanOfRequest& best, const CycleOutcome& outcome,
                                       const ToolLibrary& library) {
    std::vector<CycleTrial> trials;
    for (const FirstCut& first : firstCuts(best.plan, outcome)) {
        if (trials.size() == kMostDiameterTrials) break;
        const std::vector<AvailableCutter> wider = widerThan(first, best.plan, library);
        if (wider.empty()) continue;
        const std::optional<WiderChoice> choice = widerCutter(first.cut, wider);
        CycleTrial trial{stepFor(CycleWay::Diameter, outcome), best.request};
        trial.step.feature = first.planned->feature.id;
        trial.step.tool = first.tool->id;
        trial.step.wanted_mm = wantedDiameterMm(first.cut);
        trial.step.passes = choice ? choice->passes : 0;
        // Where none is as wide as that, the widest is the nearest to it.
        const auto widest = std::max_element(
            wider.begin(), wider.end(),
            [](const AvailableCutter& a, const AvailableCutter& b) { return a.diameter_mm < b.diameter_mm; });
        trial.step.diameter_mm = choice ? choice->diameter_mm : widest->diameter_mm;
        trial.request.wishes[trial.step.feature].first_at_least_mm = trial.step.diameter_mm;
        trials.push_back(std::move(trial));
    }
    return trials;
}

std::vector<CycleTrial> objectiveTrials(const PlanOfRequest& best, const CycleOutcome& outcome) {
    if (best.request.sequence.objective == Objective::Time) return {};
    CycleTrial trial{stepFor(CycleWay::Objective, outcome), best.request};
    trial.request.sequence.objective = Objective::Time;
    return {std::move(trial)};
}

/// All features that the time is for without one of their tools: the cheapest other way through the DAG of
/// each. Tools that cut least come first: their changes may be longer than what they save.
std::vector<CycleTrial> sequenceTrials(const PlanOfRequest& best, const CycleOutcome& outcome) {
    std::map<std::string, double> time_s;
    std::map<std::string, std::set<std::string>> features;
    for (const CutInScope& one : cutsOf(best.plan, outcome.target.of)) {
        time_s[one.operation->tool_id] += one.operation->path.totals.feed_time_s;
        features[one.operation->tool_id].insert(one.planned->feature.id);
    }
    std::vector<std::pair<double, std::string>> tools;
    tools.reserve(time_s.size());
    for (const auto& [tool, cut_s] : time_s)
        tools.emplace_back(cut_s, tool);
    std::sort(tools.begin(), tools.end());
    if (tools.size() > kMostSequenceTrials) tools.resize(kMostSequenceTrials);
    std::vector<CycleTrial> trials;
    for (const auto& [cut_s, tool] : tools) {
        CycleTrial trial{stepFor(CycleWay::Sequence, outcome), best.request};
        trial.step.tool = tool;
        for (const std::string& feature : features.at(tool))
            trial.request.wishes[feature].without_tools.insert(tool);
        trials.push_back(std::move(trial));
    }
    return trials;
}

/// Tries ways to shorter times one after another and keeps what gains.
class CycleSearch {
  public:
    CycleSearch(const Part& part, const ToolLibrary& library, const Machine& machine, const Tolerances& tol,
                const Progress& progress, SequenceMemory& memory)
        : part_(part),
          library_(library),
          machine_(machine),
          tol_(tol),
          progress_(progress),
          memory_(memory) {}

    PlanOfRequest search(const PlanRequest& request) {
        PlanOfRequest best{planPart(part_, request, library_, machine_, tol_, progress_, memory_), request};
        std::vector<CycleStep> steps = feedSteps(best.plan);
        if (overS(best.plan) > 0) {
            // Trials speak of features as this plan has them.
            best.request.assignment = best.plan.assignment;
            for (const CycleWay way : {CycleWay::Diameter, CycleWay::Objective, CycleWay::Sequence})
                for (std::size_t i = 0; i < best.plan.cycle.outcomes.size(); ++i)
                    tryOut(way, i, best, steps);
        }
        if (overS(best.plan) > 0 && request.patience.all_tools.passed()) tellOfHaste(best.plan);
        best.plan.cycle.steps = std::move(steps);
        return best;
    }

  private:
    static std::vector<CycleStep> feedSteps(const Plan& plan) {
        std::vector<CycleStep> steps;
        for (const CycleOutcome& outcome : plan.cycle.outcomes) {
            CycleStep step = stepFor(CycleWay::Feeds, outcome);
            step.before_s = outcome.planned_s;
            step.after_s = outcome.time_s;
            step.pace = outcome.pace;
            step.taken = true;
            if (outcome.pace != 1) steps.push_back(step);
        }
        return steps;
    }

    static void tellOfHaste(Plan& plan) {
        plan.warnings.push_back({"few-tools", "cycle time",
                                 "not all other tools were tried: that takes longer than --timeout allows"});
        plan.warnings = byConsequence(std::move(plan.warnings));
    }

    std::vector<CycleTrial> trialsOf(CycleWay way, const PlanOfRequest& best,
                                     const CycleOutcome& outcome) const {
        if (way == CycleWay::Diameter) return diameterTrials(best, outcome, library_);
        if (way == CycleWay::Objective) return objectiveTrials(best, outcome);
        return sequenceTrials(best, outcome);
    }

    void tryOut(CycleWay way, std::size_t target, PlanOfRequest& best, std::vector<CycleStep>& steps) const {
        const auto is_open = [&] {
            const CycleOutcome& outcome = best.plan.cycle.outcomes[target];
            return !outcome.isMet() && outcome.isTooLong() && !best.request.patience.all_tools.passed();
        };
        if (!is_open()) return;
        for (CycleTrial& trial : trialsOf(way, best, best.plan.cycle.outcomes[target])) {
            if (!is_open()) return;
            trial.step.before_s = best.plan.cycle.outcomes[target].time_s;
            trial.request = withWishesOf(std::move(trial.request), best.request);
            std::optional<Plan> plan = planIfPossible(trial.request);
            if (!plan) continue;
            judge(*plan, best.plan, target, trial.step);
            if (trial.step.taken) best = {std::move(*plan), std::move(trial.request)};
            steps.push_back(std::move(trial.step));
        }
    }

    /// A trial that cannot be planned must not lose the plan there is.
    std::optional<Plan> planIfPossible(const PlanRequest& request) const {
        try {
            return planPart(part_, request, library_, machine_, tol_, progress_, memory_);
        } catch (const std::exception&) {
            return std::nullopt;
        }
    }

    static void judge(const Plan& plan, const Plan& best, std::size_t target, CycleStep& step) {
        step.after_s = plan.cycle.outcomes[target].time_s;
        step.leaves_more = plan.balance.leftMm3() > best.balance.leftMm3() + kVolumeRoundingMm3;
        step.taken = overS(plan) < overS(best) - kNoGainS && !step.leaves_more &&
                     plan.setups.size() <= best.setups.size() && plan.threads_missing <= best.threads_missing;
    }

    /// The trial's own wishes beside those that were taken since it was thought of.
    static PlanRequest withWishesOf(PlanRequest trial, const PlanRequest& best) {
        for (const auto& [feature, wish] : best.wishes) {
            SequenceWish& own = trial.wishes[feature];
            if (own.first_at_least_mm == 0) own.first_at_least_mm = wish.first_at_least_mm;
            own.without_tools.insert(wish.without_tools.begin(), wish.without_tools.end());
        }
        return trial;
    }

    const Part& part_;
    const ToolLibrary& library_;
    const Machine& machine_;
    const Tolerances& tol_;
    const Progress& progress_;
    SequenceMemory& memory_;
};

}  // namespace

PlanOfRequest planToTime(const Part& part, const PlanRequest& request, const ToolLibrary& library,
                         const Machine& machine, const Tolerances& tol, const Progress& progress,
                         SequenceMemory& memory) {
    return CycleSearch(part, library, machine, tol, progress, memory).search(request);
}

}  // namespace stepmill
