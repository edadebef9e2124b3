#pragma once

#include <filesystem>
#include <string>

#include "stepmill/plan/plan.h"
#include "stepmill/verify/verify.h"

namespace stepmill {

/// plan.json as docs/plan-json.md describes it; checked against schemas/plan.schema.json before it leaves.
/// \throws Error(Internal) if the plan breaks its own schema.
std::string planJson(const Plan& plan);

/// The whole report as one self-contained HTML page: pictures as SVG, no scripts, no outside files.
std::string reportHtml(const Plan& plan, const Tolerances& tol);

/// The short table for the terminal: features, tools, times, what stays.
std::string summaryText(const Plan& plan);

/// Reads the programs the plan would be written with back and proves them (verify.h). Small places that the
/// paths are found to leave (no more of a feature than books may miss, `tol.volume_share`) become residuals
/// of the plan, "left between passes", with their volume in its books, so that nothing is lost silently; more
/// than that is a proof that fails.
Verification provePlan(Plan& plan, const Tolerances& tol);

/// Writes plan.json, report.html and one program per setup into `dir` (made if absent). All files are
/// complete or none is there. Without a proof no program is written and none of an earlier plan stays.
/// \param verification  what provePlan() said of this plan
/// \throws Error(OutputUnwritable)
void writePlan(const Plan& plan, const Verification& verification, const std::filesystem::path& dir,
               const Tolerances& tol);

/// Removes what a killed writePlan(…, dir, …) may have left beside `dir`. Does nothing where all is tidy.
void removeUnfinished(const std::filesystem::path& dir);

}  // namespace stepmill
