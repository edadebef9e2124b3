#include <filesystem>

#include "commands.h"
#include "output.h"
#include "plan_job.h"
#include "replan_options.h"
#include "run.h"
#include "stepmill/core/error.h"
#include "stepmill/replan/plan_change.h"
#include "stepmill/report/replan.h"
#include "stepmill/report/report.h"

namespace stepmill {

namespace {

namespace fs = std::filesystem;

/// The plan of a job with its programs, as they lie in its folder.
RecordedPlan planOfJob(const ReplanOptions& options, const Tolerances& tol) {
    const std::optional<Manifest> manifest = readManifest(options.job);
    if (manifest && !manifest->solids.empty())
        throw Error(ErrorCode::Usage, options.job,
                    "holds a job for each solid of a file; name one of these: " + options.job + "/" +
                        manifest->solids.front());
    return readPlan(options.job, std::nullopt, tol, options.plan.limits.maxFileBytes());
}

void writeReplan(const ProvenPlan& proven, const PlanChange& change, const ReplanOptions& options,
                 JobFolder& folder, const Tolerances& tol) {
    const SheetOptions sheet_options{{}, options.plan.display == "inch"};
    const Sheets sheets = makeSheets(proven, sheet_options, false, tol);
    writePlan(proven, sheets, {sheet_options.inch, options.plan.viewer}, folder, tol,
              {{"replan.html", "", replanHtml(change)}, {"replan.json", "", replanJson(change)}});
    tellReplacedEdits(folder);
}

/// Whoever reads replan.json for programs is told too.
void tellMissedTimes(const CycleTimes& times) {
    for (const CycleOutcome& outcome : times.outcomes) {
        const std::string& of = outcome.target.of;
        if (!outcome.isMet())
            tell("cycle time not met: {} {}", of.empty() ? "the part" : of, missedWords(outcome));
    }
}

int replanJob(ReplanOptions options, Workplace& place) {
    const Tolerances tol;
    const Deadline end = Deadline::in(options.plan.limits.timeout_s);
    place.progress.show("reading the job", 0);
    const RecordedPlan before = planOfJob(options, tol);
    fillFromJob(options, before.record);
    const Shop shop = shopOf(options, before.record);
    PlanRequest request = requestOf(options, before.record, shop);
    place.progress.showImport(options.plan.part_file);
    const std::vector<Part> parts = chooseParts(options.plan);
    if (parts.size() != 1)
        throw Error(ErrorCode::Usage, "--solid", "expected one solid: a job holds the plan of one");
    request.patience = patienceFor(end.secondsLeft());
    const ProvenPlan proven =
        planProven(parts.front(), request, shop.library, shop.machine, tol,
                   [&](const std::string& stage, double share) { place.progress.show(stage, share); });
    const PlanChange change =
        comparePlans(before, {proven.files, planRecordFromText(proven.files.plan_json, tol)}, tol);
    place.progress.show("writing", 1);
    if (place.folder != nullptr) writeReplan(proven, change, options, *place.folder, tol);
    if (options.plan.json)
        printData(replanJson(change));
    else
        printOut(replanText(change));
    if (place.folder != nullptr && !options.plan.json)
        printOut("\nReplan: " + (place.folder->path() / "replan.html").string() + "\n");
    tellFailures(proven);
    tellMissedTimes(proven.plan.cycle);
    return exitCodeOf(proven, options.plan, tol);
}

/// "job42-replan" beside job42, however the job was named: "job42/", ".".
fs::path besideJob(const std::string& job) {
    std::error_code unreadable;
    const fs::path folder = fs::weakly_canonical(job, unreadable);
    return unreadable ? fs::path(job + "-replan") : fs::path(folder.string() + "-replan");
}

int runReplan(const ReplanOptions& options) {
    const fs::path folder = options.diff                   ? fs::path()
                            : options.plan.out_dir.empty() ? besideJob(options.job)
                                                           : fs::path(options.plan.out_dir);
    Task task = taskOf(options.plan, folder);
    task.subject = options.job;
    return runInChild(task, [&](Workplace& place) { return replanJob(options, place); });
}

}  // namespace

void addReplanCommand(CLI::App& app, int& exit_code) {
    CLI::App* replan =
        app.add_subcommand("replan", "Plan a job's part again after a change, and keep what did not change");
    auto options = std::make_shared<ReplanOptions>();
    PlanOptions& plan = options->plan;
    plan.material.clear();
    replan->add_option("JOB", options->job, "folder of a job that plan, rough or replan wrote")->required();
    replan->add_option("--part", plan.part_file,
                       "the revised part (STEP or a drawing); default: the job's, where its file still lies "
                       "here or beside the job");
    replan->add_option("--tools", plan.tools_file, "another tool library (JSON); default: the job's");
    replan->add_option("--machine", plan.machine_file, "another machine (JSON); default: the job's");
    replan->add_option("--fixtures", plan.fixtures_file, "other fixtures (JSON); default: the job's");
    replan->add_option("--holes", plan.holes_file, "another hole table (JSON); default: the job's");
    replan->add_option("--material", plan.material, "another material; default: the job's");
    replan
        ->add_option(
            "--cycle-time", options->cycle_times,
            "a time to take, of the part (4:30), a setup (S1=2:00) or a feature (S1.F3=0:45), as often "
            "as needed; off: none; default: the job's")
        ->allow_extra_args(false);
    replan->add_option("--solid", plan.solid, "which solid of a revised file with several: a number");
    addDrawingOptions(*replan, plan.drawing);
    CLI::Option* output =
        replan->add_option("-o,--output", plan.out_dir,
                           "folder to write the new job to, which may be JOB itself; default: JOB-replan");
    replan->add_flag("--diff", options->diff, "print what would be another, and write nothing")
        ->excludes(output);
    replan->add_flag("--json", plan.json, "print replan.json instead of the text");
    replan->add_option("--display", plan.display, "unit of report and setup sheets")
        ->check(CLI::IsMember({"mm", "inch"}))
        ->capture_default_str();
    replan->add_flag("!--no-viewer", plan.viewer, "a plain report.html: no script");
    replan->add_flag("--strict", plan.strict, "exit 1 on any warning as well");
    replan->add_option("--jobs", plan.jobs, "threads; 0: one per core")->check(numberFrom(0, 1024, ""));
    addLimitOptions(*replan, plan.limits);
    replan->footer(
        "Features and operations that are still there keep their ids and their order.\n"
        "Examples:\n"
        "  stepmill replan job42 --part bracket_b.step\n"
        "  stepmill replan job42 --part bracket_b.step --diff\n"
        "  stepmill replan job42 --part bracket_b.step -o job42\n"
        "  stepmill replan job42 --tools new_shop.json --machine other_mill.json\n"
        "  stepmill replan job42 --material steel --diff --json\n"
        "  stepmill replan job42 --cycle-time 4:30\n"
        "  stepmill replan job42 --cycle-time S1=2:00 --cycle-time S2.F3=0:45 --diff\n"
        "  stepmill replan job42 --fixtures clamps.json -o job42-clamps");
    replan->callback([options, &exit_code] { exit_code = runReplan(*options); });
}

}  // namespace stepmill
