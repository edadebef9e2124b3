// The plan's programs, proven before they are written.

#include <fmt/format.h>

#include "plan/plan_steps.h"
#include "report/posted_files.h"
#include "stepmill/core/error.h"
#include "stepmill/report/report.h"

namespace stepmill {

namespace report {

PlanFiles postedFiles(const Plan& plan) {
    PlanFiles files;
    files.plan_json = planJson(plan);
    files.dialect = dialectOf(plan.machine);
    for (const PlannedSetup& setup : plan.setups)
        files.programs[setup.setup.id] = post(jobOf(plan, setup), {files.dialect});
    return files;
}

}  // namespace report

namespace {

/// What our own reader cannot take is a proof that fails.
Verification verified(const Plan& plan, const Tolerances& tol) {
    const PlanFiles files = report::postedFiles(plan);
    try {
        return verifyPlan(files, tol);
    } catch (const Error& error) {
        Verification verification;
        verification.failures.push_back({error.subject(), 0, "", error.what()});
        return verification;
    }
}

void moveToResidual(VolumeBalance& books, double volume_mm3) {
    books.planned_mm3 -= volume_mm3;
    books.residual_mm3 += volume_mm3;
    for (ReasonVolume& entry : books.residual_by_reason) {
        if (entry.reason != kLeftBetweenPasses) continue;
        entry.volume_mm3 += volume_mm3;
        return;
    }
    books.residual_by_reason.push_back({kLeftBetweenPasses, volume_mm3});
    std::sort(books.residual_by_reason.begin(), books.residual_by_reason.end(),
              [](const ReasonVolume& a, const ReasonVolume& b) { return a.reason < b.reason; });
}

void nameLeftover(Plan& plan, const Leftover& leftover) {
    Residual residual;
    residual.region = leftover.region;
    residual.area_mm2 = leftover.area_mm2;
    residual.volume_mm3 = leftover.area_mm2 * leftover.height_mm;
    residual.reason = kLeftBetweenPasses;
    residual.advice = "a finishing pass, or a smaller step-over in the cutting data";
    for (PlannedSetup& setup : plan.setups) {
        for (PlannedFeature& planned : setup.features) {
            if (planned.feature.id != leftover.feature) continue;
            moveToResidual(setup.balance, residual.volume_mm3);
            moveToResidual(plan.balance, residual.volume_mm3);
            plan.warnings.push_back(
                {"residual", leftover.feature,
                 fmt::format("{:.4g} mm2, {:.4g} mm3 stay: {}; needs {}", residual.area_mm2,
                             residual.volume_mm3, residual.reason, residual.advice)});
            planned.sequence.residual.push_back(residual);
        }
    }
}

}  // namespace

Verification provePlan(Plan& plan, const Tolerances& tol) {
    Verification verification = verified(plan, tol);
    bool any_named = false;
    for (const Leftover& leftover : verification.leftovers) {
        if (leftover.area_mm2 > std::max(kCrumbMm2, tol.volume_share * leftover.target_mm2)) continue;
        nameLeftover(plan, leftover);
        any_named = true;
    }
    return any_named ? verified(plan, tol) : verification;
}

}  // namespace stepmill
