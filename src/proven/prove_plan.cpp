// Plans whose programs are proven before they are written.

#include <algorithm>

#include <fmt/format.h>

#include "stepmill/core/error.h"
#include "stepmill/plan/reduced_feature.h"
#include "stepmill/plan/sequence_memory.h"
#include "stepmill/plan/warning_order.h"
#include "stepmill/proven/proven_plan.h"

namespace stepmill {
namespace {

/// So many tools are taken from a feature one after another before it is dropped.
constexpr std::size_t kMostToolsWithheld = 3;
/// So often what stays is named before the feature is dropped.
constexpr std::size_t kMostLeftNamed = 3;
/// What failed is planned in safer ways, one after another, while there is time for another such round and
/// then for a last one, which takes about so many times as long as a proof and drops what failed.
constexpr double kLastRoundProofs = 4;

/// What our own reader cannot take is a proof that fails.
Verification verified(const PlanFiles& files, const Tolerances& tol, const Prover& prover) {
    try {
        return prover(files, tol);
    } catch (const Error& error) {
        Verification verification;
        verification.failures.push_back({error.subject(), 0, "", error.what()});
        return verification;
    }
}

// What passes leave ---------------------------------------------------------------------------------------

/// The books with that volume [mm3] moved from what is planned to what stays between passes.
VolumeBalance withLeftBetweenPasses(VolumeBalance books, double volume_mm3) {
    books.planned_mm3 -= volume_mm3;
    books.residual_mm3 += volume_mm3;
    for (ReasonVolume& entry : books.residual_by_reason) {
        if (entry.reason != Reason::LeftBetweenPasses) continue;
        entry.volume_mm3 += volume_mm3;
        return books;
    }
    books.residual_by_reason.push_back({{Reason::LeftBetweenPasses, {}}, volume_mm3});
    std::sort(
        books.residual_by_reason.begin(), books.residual_by_reason.end(),
        [](const ReasonVolume& a, const ReasonVolume& b) { return InOrderOfWords()(a.reason, b.reason); });
    return books;
}

Residual residualOf(const Leftover& leftover, Reason reason) {
    Residual residual;
    residual.region = leftover.region;
    residual.area_mm2 = leftover.area_mm2;
    residual.volume_mm3 = leftover.area_mm2 * leftover.height_mm;
    residual.stays_mm3 = residual.volume_mm3;
    residual.reason = {reason, {}};
    residual.advice = "a finishing pass, or a smaller step-over in the cutting data";
    return residual;
}

Warning warningOf(const std::string& feature, const Residual& residual) {
    return {"residual", feature,
            fmt::format("{:.4g} mm2, {:.4g} mm3 stay: {}; needs {}", residual.area_mm2, residual.volume_mm3,
                        toString(residual.reason), residual.advice)};
}

/// The plan with a residual that its paths leave: in the feature, the books and the warnings.
Plan withLeftover(Plan plan, const Leftover& leftover) {
    const Residual residual = residualOf(leftover, Reason::LeftBetweenPasses);
    for (PlannedSetup& setup : plan.setups) {
        for (PlannedFeature& planned : setup.features) {
            if (planned.feature.id != leftover.feature) continue;
            setup.balance = withLeftBetweenPasses(std::move(setup.balance), residual.volume_mm3);
            plan.balance = withLeftBetweenPasses(std::move(plan.balance), residual.volume_mm3);
            plan.warnings.push_back(warningOf(leftover.feature, residual));
            plan.warnings = byConsequence(std::move(plan.warnings));
            planned.sequence.residual.push_back(residual);
        }
    }
    return plan;
}

/// The leftovers so small that the plan names them as it is: nothing that it counts on changes.
std::vector<Leftover> crumbsOf(const Verification& verification, const Tolerances& tol) {
    std::vector<Leftover> crumbs;
    for (const Leftover& leftover : verification.leftovers)
        if (leftover.area_mm2 <= std::max(kCrumbMm2, tol.volume_share * leftover.target_mm2))
            crumbs.push_back(leftover);
    return crumbs;
}

ProvenPlan provenAsItIs(Plan plan, const Tolerances& tol, const Prover& prover) {
    ProvenPlan proven{std::move(plan), {}, {}};
    proven.files = postedFiles(proven.plan);
    proven.verification = verified(proven.files, tol, prover);
    return proven;
}

/// Proves the plan, and again with its crumbs named where there are any.
ProvenPlan proved(Plan plan, const Tolerances& tol, const Prover& prover) {
    ProvenPlan proven = provenAsItIs(std::move(plan), tol, prover);
    const std::vector<Leftover> crumbs = crumbsOf(proven.verification, tol);
    if (crumbs.empty()) return proven;
    Plan named = std::move(proven.plan);
    for (const Leftover& crumb : crumbs)
        named = withLeftover(std::move(named), crumb);
    return provenAsItIs(std::move(named), tol, prover);
}

// More caution --------------------------------------------------------------------------------------------

/// What failed in one feature.
struct FailedFeature {
    std::set<std::string> tools;
    std::string first;      ///< failure, for people
    bool adaptive = false;  ///< one of its failures is in an operation of constant engagement
    int failures = 0;
    std::vector<Residual> left;  ///< each is one of the failures

    bool onlyLeaves() const { return failures == static_cast<int>(left.size()); }
};
using FailedFeatures = std::map<std::string, FailedFeature>;

FailedFeatures failedIn(const PlannedSetup& setup, const Verification& verification) {
    FailedFeatures failed;
    for (const Operation& operation : setup.operations) {
        for (const ProofFailure& failure : verification.failures) {
            if (failure.operation != operation.id) continue;
            FailedFeature& feature = failed[operation.feature_id];
            feature.tools.insert(operation.tool_id);
            feature.adaptive |= operation.engagement_deg > 0;
            if (feature.failures++ == 0)
                feature.first = fmt::format("{}, {}, line {}: {}", operation.tool_id, failure.file,
                                            failure.line, failure.text);
        }
    }
    for (const Leftover& leftover : verification.leftovers)
        if (const auto found = failed.find(leftover.feature); found != failed.end())
            found->second.left.push_back(residualOf(leftover, Reason::NotProven));
    return failed;
}

/// The next safer way to plan the feature.
/// \pre it is not dropped
void addCaution(FeatureCaution& caution, const FailedFeature& failed) {
    if (caution.why.empty()) caution.why = failed.first;
    if (failed.adaptive && !caution.not_adaptive) {
        caution.not_adaptive = true;
    } else if (!caution.plain_ways) {
        caution.plain_ways = true;
    } else if (failed.onlyLeaves() && caution.left.size() < kMostLeftNamed) {
        caution.left.insert(caution.left.end(), failed.left.begin(), failed.left.end());
    } else if (!failed.onlyLeaves() && caution.without_tools.size() < kMostToolsWithheld) {
        caution.without_tools.insert(failed.tools.begin(), failed.tools.end());
    } else {
        caution.dropped = true;
    }
}

/// Forgets what was found out of setups after this one: their stock is another now.
void forgetLater(const Plan& plan, std::size_t setup, Cautions& cautions) {
    for (std::size_t later = setup + 1; later < plan.setups.size(); ++later)
        std::erase_if(cautions, [&](const auto& entry) {
            return entry.first.starts_with(plan.setups[later].setup.id + ".");
        });
}

/// Drops all that failed, in every setup; false where nothing can be done.
bool dropFailed(const ProvenPlan& proven, Cautions& cautions) {
    bool any = false;
    for (const PlannedSetup& setup : proven.plan.setups)
        for (const auto& [id, feature] : failedIn(setup, proven.verification)) {
            FeatureCaution& caution = cautions[id];
            if (caution.why.empty()) caution.why = feature.first;
            any |= !caution.dropped;
            caution.dropped = true;
        }
    return any;
}

/// More caution in the first setup that has failures; false where nothing can be done.
bool addCautions(const ProvenPlan& proven, Cautions& cautions) {
    for (std::size_t s = 0; s < proven.plan.setups.size(); ++s) {
        const FailedFeatures failed = failedIn(proven.plan.setups[s], proven.verification);
        if (failed.empty()) continue;
        for (const auto& [id, feature] : failed)
            addCaution(cautions[id], feature);
        forgetLater(proven.plan, s, cautions);
        return true;
    }
    return false;
}

}  // namespace

bool ProvenPlan::mayRun() const {
    const bool books_close = std::none_of(plan.warnings.begin(), plan.warnings.end(),
                                          [](const Warning& warning) { return warning.code == "books"; });
    return verification.proven() && books_close;
}

ProvenPlan planProven(const Part& part, const PlanRequest& request, const ToolLibrary& library,
                      const Machine& machine, const Tolerances& tol, const Progress& progress,
                      const Prover& prover) {
    SequenceMemory memory;
    auto [plan, careful] = planToTime(part, request, library, machine, tol, progress, memory);
    const std::vector<CycleStep> steps = plan.cycle.steps;
    const Deadline end = careful.patience.end;
    double before_s = end.secondsLeft();
    for (;;) {
        if (progress) progress("proving the programs", 1);
        const double begun_s = end.secondsLeft();
        ProvenPlan proven = proved(std::move(plan), tol, prover);
        const double left_s = end.secondsLeft();
        const double last_round_s = kLastRoundProofs * (begun_s - left_s);
        const bool one_more = left_s < std::max(before_s - left_s, last_round_s) + last_round_s;
        before_s = left_s;
        if (proven.verification.proven() || !(one_more ? dropFailed : addCautions)(proven, careful.cautions))
            return proven;
        // A caution speaks of features as this plan has them.
        careful.assignment = proven.plan.assignment;
        careful.patience = patienceAfter(careful.patience);
        plan = planPart(part, careful, library, machine, tol, progress, memory);
        plan.cycle.steps = steps;
    }
}

}  // namespace stepmill
