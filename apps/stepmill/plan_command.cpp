#include <filesystem>

#include <fmt/core.h>

#include "commands.h"
#include "options.h"
#include "output.h"
#include "run.h"
#include "stepmill/report/report.h"

namespace stepmill {

namespace {

namespace fs = std::filesystem;

bool hasGaps(const Plan& plan, const PlanOptions& options, const Tolerances& tol) {
    const bool doubtful = std::any_of(plan.warnings.begin(), plan.warnings.end(), [](const Warning& warning) {
        return warning.code == "unit-doubt" || warning.code == "input-doubt";
    });
    return !plan.complete(tol) || doubtful || (options.strict && !plan.warnings.empty());
}

/// Books that do not close and proofs that fail are bugs of ours: warnings and proofs say where.
int exitCodeOf(const ProvenPlan& proven, const PlanOptions& options, const Tolerances& tol) {
    if (!proven.mayRun()) return kBug;
    return hasGaps(proven.plan, options, tol) ? kGaps : kComplete;
}

/// A job's folder as a path from where the user is: below --output, not below where a link there leads.
fs::path asGiven(const JobFolder& folder, const PlanOptions& options) {
    const fs::path given = outputFolder(options, "-plan");
    const std::string name = folder.path().filename().string();
    std::error_code ignored;
    return fs::equivalent(folder.path(), given, ignored) ? given : given / name;
}

void tellFailures(const Verification& verification) {
    for (const ProofFailure& failure : verification.failures) {
        const std::string operation = failure.operation.empty() ? "" : failure.operation + " of ";
        const std::string line = failure.line > 0 ? fmt::format(", line {}", failure.line) : "";
        tell("no program is written: {}{}{}: {}", operation, failure.file, line, failure.text);
    }
}

/// Plans, proves and writes one part, and tells what came of it.
int planOne(const Part& part, const PlanOptions& options, const PlanRequest& request, const Shop& shop,
            JobFolder& folder, ProgressLine& progress) {
    const Tolerances tol;
    const ProvenPlan proven =
        planProven(part, request, shop.library, shop.machine, tol,
                   [&](const std::string& stage, double share) { progress.show(stage, share); });
    progress.show("writing the report", 1);
    writePlan(proven, folder, tol);
    tellReplacedEdits(folder);
    progress.show("done", 1);
    if (options.json)
        printData(proven.files.plan_json + "\n");
    else
        printOut(fmt::format("{}\nReport: {}\n", summaryText(proven.plan),
                             (asGiven(folder, options) / "report.html").string()));
    tellFailures(proven.verification);
    return exitCodeOf(proven, options, tol);
}

NewJob withSolidsOf(const Manifest& before, NewJob job) {
    for (const std::string& solid : before.solids)
        if (std::find(job.solids.begin(), job.solids.end(), solid) == job.solids.end())
            job.solids.push_back(solid);
    return job;
}

/// Each solid is a job of its own, in a folder below; the folder above names them.
int planSolids(const std::vector<Part>& parts, const PlanOptions& options, const PlanRequest& request,
               const Shop& shop, Workplace& place) {
    int exit_code = kComplete;
    NewJob all{JobWriter::Plan, parts.front().file, parts.front().sha256, "", {}, {}};
    const Manifest before = readManifest(place.folder->path()).value_or(Manifest{});
    for (const Part& part : parts) {
        all.solids.push_back(fmt::format("solid-{}", part.solid_index));
        JobFolder folder(place.folder->path() / all.solids.back());
        exit_code = std::max(exit_code, planOne(part, options, request, shop, folder, place.progress));
        place.folder->write(withSolidsOf(before, all));  // a run that is stopped later leaves none unnamed
    }
    place.folder->write(all);
    return exit_code;
}

int planAll(const PlanOptions& options, Workplace& place) {
    place.progress.show("reading tools and machine", 0);
    const Shop shop = loadShop(options);
    place.progress.showImport(options.part_file);
    const PlanRequest request = planRequest(options, shop.machine);
    const std::vector<Part> parts = chooseParts(options);
    reportImport(parts, options);
    if (parts.size() > 1) return planSolids(parts, options, request, shop, place);
    return planOne(parts.front(), options, request, shop, *place.folder, place.progress);
}

int runPlan(const PlanOptions& options) {
    return runInChild(taskOf(options, outputFolder(options, "-plan")),
                      [&](Workplace& place) { return planAll(options, place); });
}

}  // namespace

void addPlanCommand(CLI::App& app, int& exit_code) {
    CLI::App* plan =
        app.add_subcommand("plan", "Plan a STEP part and write plan.json, report.html and programs");
    auto options = std::make_shared<PlanOptions>();
    addPartOptions(*plan, *options, "-plan");
    plan->add_option("--tools", options->tools_file,
                     "tool library (JSON); default: a metric shop of 24 tools");
    plan->add_option("--machine", options->machine_file, "machine (JSON); default: a machining centre");
    plan->add_option("--fixtures", options->fixtures_file,
                     "what holds the part in each setup (JSON); default: the jaws of the suggested vise");
    plan->add_option("--material", options->material, "material the cutting data are for")
        ->capture_default_str();
    plan->add_option("--objective", options->objective, "what the tool sequence makes least")
        ->check(CLI::IsMember({"time", "cost"}))
        ->capture_default_str();
    plan->add_option("--surrogates", options->surrogates,
                     "who clears what a tool's holder keeps from it: one tool per place (single), or the "
                     "cheapest sequence of tools")
        ->check(CLI::IsMember({"single", "sequence"}))
        ->capture_default_str();
    plan->add_option("--cost-model", options->cost_model,
                     "what tools are chosen by: real tool paths, or an area model of the papers (yao, lim); "
                     "the plan's times are those of its paths")
        ->check(CLI::IsMember({"paths", "yao", "lim"}))
        ->capture_default_str();
    plan->add_option("--finish-walls", options->finish_walls_mm,
                     "mm that roughing leaves on walls for a finishing pass along them; 0: no such pass")
        ->capture_default_str();
    plan->add_option("--finish-floors", options->finish_floors_mm,
                     "mm that roughing leaves on floors for a finishing pass over them; 0: no such pass")
        ->capture_default_str();
    plan->add_option("--scallop", options->scallop_mm,
                     "mm of the ridges that ball, bull-nose and chamfer cutters leave on walls that lean; 0: "
                     "none of them is used there")
        ->capture_default_str();
    addImportOption(*plan, *options);
    plan->add_flag("--strict", options->strict, "exit 1 on any warning as well");
    plan->add_flag("--json", options->json, "print plan.json on standard output instead of the summary");
    plan->footer(
        "Examples:\n"
        "  stepmill plan bracket.step\n"
        "  stepmill plan bracket.step --setup +z --setup -z\n"
        "  stepmill plan bracket.step --no-setup -z --no-setup -x\n"
        "  stepmill plan bracket.step -o job42 --setup +z --stock-margin 2,1,0 --material steel\n"
        "  stepmill plan bracket.step --finish-walls 0.3 --finish-floors 0.2\n"
        "  stepmill plan bracket.step --tools my_tools.json --machine my_mill.json --objective cost\n"
        "  stepmill plan bracket.step --fixtures clamps.json");
    plan->callback([options, &exit_code] { exit_code = runPlan(*options); });
}

}  // namespace stepmill
