// A whole plan from a STEP file: setups, features, operations, times, and the folder with programs,
// report and sheets. Usage: plan_a_part PART.step FOLDER

#include <cstdio>
#include <exception>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/report/report.h"

namespace {

using namespace stepmill;

int planPartFile(const char* file, const char* folder) {
    const Tolerances tol;
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.sequence.retract_mm = defaultMachine().safe_height_mm;
    const ProvenPlan proven =
        planProven(readStep(file).front(), request, defaultToolLibrary(), defaultMachine(), tol);
    for (const PlannedSetup& setup : proven.plan.setups)
        for (const Operation& operation : setup.operations)
            std::printf("%-8s %-8s %-8s %6.1f s\n", operation.id.c_str(), operation.feature_id.c_str(),
                        operation.tool_id.c_str(), operation.path.totals.time_s());
    std::printf("total %.1f s, %s\n", proven.plan.totals.time_s,
                proven.verification.proven() ? "proven" : "not proven");
    JobFolder job(folder);
    writePlan(proven, makeSheets(proven, SheetOptions(), false, tol), ReportOptions(), job, tol);
    return proven.mayRun() ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: plan_a_part PART.step FOLDER\n");
        return 2;
    }
    try {
        return planPartFile(argv[1], argv[2]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "plan_a_part: %s\n", error.what());
        return 2;
    }
}
