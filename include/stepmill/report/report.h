#pragma once

#include <string>

#include "stepmill/job/job_folder.h"
#include "stepmill/plan/plan.h"
#include "stepmill/proven/proven_plan.h"
#include "stepmill/report/sheets.h"

namespace stepmill {

/// The whole report as one self-contained HTML page: pictures as SVG, no scripts, no outside files.
std::string reportHtml(const Plan& plan, const Tolerances& tol);

/// The short table for the terminal: features, tools, times, what stays.
std::string summaryText(const Plan& plan);

/// Writes plan.json, report.html, the setup sheets and one program per setup as the job of that folder, in
/// place of the job that was there. Unless proven.mayRun() no program is written, and none of an earlier plan
/// stays.
/// \throws Error(OutputUnwritable): the folder then holds what it held
void writePlan(const ProvenPlan& proven, const Sheets& sheets, JobFolder& folder, const Tolerances& tol);

}  // namespace stepmill
