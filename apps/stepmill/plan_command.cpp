#include <unistd.h>

#include <filesystem>

#include <fmt/core.h>
#include <oneapi/tbb/global_control.h>

#include "commands.h"
#include "options.h"
#include "stepmill/core/error.h"
#include "stepmill/core/supervise.h"
#include "stepmill/report/report.h"

namespace stepmill {

namespace {

namespace fs = std::filesystem;

fs::path outputFolder(const PlanOptions& options) {
    return options.out_dir.empty() ? fs::path(fs::path(options.part_file).stem().string() + "-plan")
                                   : fs::path(options.out_dir);
}

/// A line on a terminal that is overwritten; silent elsewhere.
class ProgressLine {
  public:
    explicit ProgressLine(StageBoard& board) : board_(board), terminal_(isatty(STDERR_FILENO) != 0) {}
    ~ProgressLine() {
        if (terminal_) fmt::print(stderr, "\r\033[K");
    }
    ProgressLine(const ProgressLine&) = delete;
    ProgressLine& operator=(const ProgressLine&) = delete;

    void show(const std::string& stage, double share) {
        board_.set(stage);
        if (!terminal_) return;
        constexpr int kWidth = 30;
        const int done = std::clamp(static_cast<int>(share * kWidth), 0, kWidth);
        fmt::print(stderr, "\r\033[K[{}{}] {}", std::string(done, '#'), std::string(kWidth - done, '.'),
                   stage);
        std::fflush(stderr);
    }

  private:
    StageBoard& board_;
    bool terminal_;
};

bool hasGaps(const Plan& plan, const PlanOptions& options, const Tolerances& tol) {
    const bool doubtful = std::any_of(plan.warnings.begin(), plan.warnings.end(), [](const Warning& warning) {
        return warning.code == "unit-doubt" || warning.code == "input-doubt";
    });
    return !plan.complete(tol) || doubtful || (options.strict && !plan.warnings.empty());
}

int planAll(const PlanOptions& options, StageBoard& board) {
    ProgressLine progress(board);
    std::optional<tbb::global_control> threads;
    if (options.jobs > 0) threads.emplace(tbb::global_control::max_allowed_parallelism, options.jobs);

    const Tolerances tol;
    const Shop shop = loadShop(options);
    progress.show("importing " + fs::path(options.part_file).filename().string(), 0);
    const PlanRequest request = planRequest(options, shop.machine);
    const std::vector<Part> parts = chooseParts(options);

    int exit_code = kComplete;
    for (const Part& part : parts) {
        const Plan plan =
            planPart(part, request, shop.library, shop.machine, tol,
                     [&](const std::string& stage, double share) { progress.show(stage, share); });
        fs::path folder = outputFolder(options);
        if (parts.size() > 1) folder /= fmt::format("solid-{}", part.solid_index);
        progress.show("writing the report", 1);
        writePlan(plan, folder, tol);
        progress.show("done", 1);
        if (options.json)
            fmt::print("{}\n", planJson(plan));
        else
            fmt::print("{}\nReport: {}\n", summaryText(plan), (folder / "report.html").string());
        if (hasGaps(plan, options, tol)) exit_code = kGaps;
    }
    return exit_code;
}

int runPlan(const PlanOptions& options) {
    const Supervised run = runSupervised(
        [&](StageBoard& board) {
            try {
                return planAll(options, board);
            } catch (const std::exception& error) {
                return reportError(error);
            }
        },
        options.timeout_s);
    if (run.end == Supervised::End::Exited) return run.exit_code;

    removeUnfinished(outputFolder(options));
    const bool importing = run.last_stage.rfind("importing", 0) == 0;
    if (run.end == Supervised::End::TimedOut) {
        fmt::print(stderr, "stepmill: {}: stopped after {:g} s while {}; allow more with --timeout\n",
                   options.part_file, options.timeout_s, run.last_stage);
        return kBadInput;
    }
    fmt::print(stderr, "stepmill: {}: the geometry kernel crashed (signal {}) while {}\n", options.part_file,
               run.signal, run.last_stage);
    return importing ? kBadInput : kBug;
}

}  // namespace

void addPlanCommand(CLI::App& app, int& exit_code) {
    CLI::App* plan =
        app.add_subcommand("plan", "Plan a STEP part and write plan.json, report.html and programs");
    auto options = std::make_shared<PlanOptions>();
    plan->add_option("PART", options->part_file, "STEP file (AP203, AP214 or AP242)")->required();
    plan->add_option("-o,--output", options->out_dir, "folder to write to; default: <part>-plan");
    plan->add_option("--tools", options->tools_file,
                     "tool library (JSON); default: a metric shop of 24 tools");
    plan->add_option("--machine", options->machine_file, "machine (JSON); default: a machining centre");
    plan->add_option("--material", options->material, "material the cutting data are for")
        ->capture_default_str();
    plan->add_option("--stock", options->stock, "box, or a STEP file in the part's coordinates")
        ->capture_default_str();
    plan->add_option("--stock-margin", options->stock_margin, "side,top,bottom over the part's box [mm]")
        ->capture_default_str();
    plan->add_option("--setup", options->setup, "tool axis: auto, +z, -z, +x, -x, +y, -y or x,y,z")
        ->capture_default_str();
    plan->add_option("--objective", options->objective, "what the tool sequence makes least")
        ->check(CLI::IsMember({"time", "cost"}))
        ->capture_default_str();
    plan->add_option("--solid", options->solid, "which solid of a file with several: a number, or all");
    plan->add_option("--unit", options->unit, "read lengths in this unit, whatever the file says")
        ->check(CLI::IsMember({"mm", "inch", "m", "cm"}));
    plan->add_option("--jobs", options->jobs, "threads; 0: one per core")->check(CLI::NonNegativeNumber);
    plan->add_option("--timeout", options->timeout_s, "seconds after which the run ends for good")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    plan->add_flag("--strict", options->strict, "exit 1 on any warning as well");
    plan->add_flag("--json", options->json, "print plan.json on standard output instead of the summary");
    plan->footer(
        "Examples:\n"
        "  stepmill plan bracket.step\n"
        "  stepmill plan bracket.step -o job42 --setup +z --stock-margin 2,1,0 --material steel\n"
        "  stepmill plan bracket.step --tools my_tools.json --machine my_mill.json --objective cost");
    plan->callback([options, &exit_code] { exit_code = runPlan(*options); });
}

}  // namespace stepmill
