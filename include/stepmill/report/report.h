#pragma once

#include <string>
#include <vector>

#include "stepmill/job/job_folder.h"
#include "stepmill/plan/plan.h"
#include "stepmill/proven/proven_plan.h"
#include "stepmill/report/sheets.h"

namespace stepmill {

/// What a report is to have and how it is to show it.
struct ReportOptions {
    bool inch = false;   ///< lengths and feeds in inches
    bool viewer = true;  ///< the part and the run of its programs to look at, turn and play; needs scripts
};

/// The whole report as one self-contained HTML page [docs/report.md]: pictures as SVG, no outside files. Its
/// only scripts are the viewer's.
/// \throws Error(GeometryKernel) where part or stock cannot be meshed for the viewer
std::string reportHtml(const ProvenPlan& proven, const ReportOptions& options, const Tolerances& tol);
/// Of a plan without programs: nothing to play, so no viewer.
std::string reportHtml(const Plan& plan, const Tolerances& tol);

/// The short table for the terminal: features, tools, times, what stays.
std::string summaryText(const Plan& plan);

/// Writes plan.json, report.html, the setup sheets and a program for each setup in which something is cut as
/// the job of that folder, in place of the job that was there. Unless proven.mayRun() no program is written,
/// and none of an earlier plan stays.
/// \param beside  files of the same job that say more of the plan
/// \throws Error(OutputUnwritable): the folder then holds what it held
void writePlan(const ProvenPlan& proven, const Sheets& sheets, const ReportOptions& report, JobFolder& folder,
               const Tolerances& tol, const std::vector<NewFile>& beside = {});

}  // namespace stepmill
