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

/// Writes plan.json, report.html and one program per setup into `dir` (made if absent). All files are
/// complete or none is there. The programs are read back and proven first (verify.h): where a proof fails,
/// none is written and none of an earlier plan stays. \throws Error(OutputUnwritable)
Verification writePlan(const Plan& plan, const std::filesystem::path& dir, const Tolerances& tol);

/// Removes what a killed writePlan(…, dir, …) may have left beside `dir`. Does nothing where all is tidy.
void removeUnfinished(const std::filesystem::path& dir);

}  // namespace stepmill
