#include <filesystem>

#include <fmt/core.h>

#include "commands.h"
#include "options.h"
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
    const Plan& plan = proven.plan;
    if (!proven.verification.proven()) return kBug;
    const bool books_open = std::any_of(plan.warnings.begin(), plan.warnings.end(),
                                        [](const Warning& warning) { return warning.code == "books"; });
    if (books_open) return kBug;
    return hasGaps(plan, options, tol) ? kGaps : kComplete;
}

void tellFailures(const Verification& verification) {
    for (const ProofFailure& failure : verification.failures) {
        const std::string operation = failure.operation.empty() ? "" : failure.operation + " of ";
        const std::string line = failure.line > 0 ? fmt::format(", line {}", failure.line) : "";
        fmt::print(stderr, "stepmill: no program is written: {}{}{}: {}\n", operation, failure.file, line,
                   failure.text);
    }
}

int planAll(const PlanOptions& options, const fs::path& out_folder, ProgressLine& progress) {
    const Tolerances tol;
    const Shop shop = loadShop(options);
    progress.show("importing " + fs::path(options.part_file).filename().string(), 0);
    const PlanRequest request = planRequest(options, shop.machine);
    const std::vector<Part> parts = chooseParts(options);

    int exit_code = kComplete;
    for (const Part& part : parts) {
        const ProvenPlan proven =
            planProven(part, request, shop.library, shop.machine, tol,
                       [&](const std::string& stage, double share) { progress.show(stage, share); });
        fs::path folder = out_folder;
        if (parts.size() > 1) folder /= fmt::format("solid-{}", part.solid_index);
        progress.show("writing the report", 1);
        writePlan(proven, folder, tol);
        progress.show("done", 1);
        if (options.json)
            fmt::print("{}\n", proven.files.plan_json);
        else
            fmt::print("{}\nReport: {}\n", summaryText(proven.plan), (folder / "report.html").string());
        tellFailures(proven.verification);
        exit_code = std::max(exit_code, exitCodeOf(proven, options, tol));
    }
    return exit_code;
}

int runPlan(const PlanOptions& options) {
    const fs::path folder = outputFolder(options, "-plan");
    return runInChild(options, folder,
                      [&](ProgressLine& progress) { return planAll(options, folder, progress); });
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
