#include "report/page/program_lines.h"
#include "stepmill/core/file.h"
#include "stepmill/report/report.h"

namespace stepmill {

void writePlan(const ProvenPlan& proven, const Sheets& sheets, const ReportOptions& report, JobFolder& folder,
               const Tolerances& tol, const std::vector<NewFile>& beside) {
    NewJob job;
    job.by = JobWriter::Plan;
    job.part_file = proven.plan.part.file;
    job.part_sha256 = proven.plan.part.sha256;
    job.plan_sha256 = sha256(proven.files.plan_json);
    job.files.push_back({"plan.json", "", proven.files.plan_json});
    job.files.push_back({"report.html", "", reportHtml(proven, report, tol)});
    job.files.push_back({"sheets.html", "", sheets.html});
    if (!sheets.pdf.empty()) job.files.push_back({"sheets.pdf", "", sheets.pdf});
    job.files.insert(job.files.end(), beside.begin(), beside.end());
    for (const PlannedSetup& setup : proven.plan.setups)
        if (report::programOf(proven, setup) != nullptr)
            for (const PostedProgram& program : proven.files.programs.at(setup.setup.id))
                job.files.push_back({program.file, toString(proven.files.dialect), program.text});
    folder.write(job);
}

}  // namespace stepmill
