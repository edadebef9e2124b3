#include <filesystem>
#include <thread>

#include <fmt/core.h>

#include "batch_cluster.h"
#include "batch_folder.h"
#include "batch_progress.h"
#include "batch_work.h"
#include "commands.h"
#include "output.h"
#include "plan_job.h"
#include "run.h"
#include "stepmill/batch/tidy_batch.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/core/plain_text.h"
#include "stepmill/report/batch_page.h"

namespace stepmill {

namespace fs = std::filesystem;

namespace {

int cores() {
    return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

/// What jobs tell while they run and how they are planned.
JobWork jobWork(const BatchOptions& options, const BatchPlan& plan, const JobLimits& limits,
                BatchProgress& progress) {
    const int threads = std::max(1, cores() / limits.at_once);
    return {[&options, &plan, threads](const BatchJob& job, JobFolder& folder, StageBoard& board) {
                return planBatchJob(options, plan, job, threads, folder, board);
            },
            [&options](const Supervised& end) { return endWords(end, options.limits).text; },
            [&progress](const BatchJob& job) { progress.done(job); }};
}

/// \return the signal that stopped it, 0 for none, and the exit code
std::pair<int, int> runBatch(const BatchOptions& options) {
    const BatchPlan plan = listBatch(options, programIdentity());
    const fs::path out = options.out_dir;
    const std::unique_ptr<FolderLock> lock = takeBatchFolder(options);
    tidyBatch(out);
    Ledger ledger(ledgerFile(out));
    ledger.setParts(plan.parts);
    const std::vector<BatchJob> to_do = jobsToDo(plan, options, ledger);
    BatchProgress progress(plan, to_do);
    JobLimits limits = jobLimits(options, options.at_once);
    const std::unique_ptr<MemoryGroups> groups = MemoryGroups::take(ownGroupFolder());
    limits.each.groups = groups.get();
    tell("each part may take {:g} GB of memory ({})", options.limits.memory_gb,
         groups ? "cgroup v2 and RLIMIT_DATA" : "RLIMIT_DATA");
    const int signal = runJobs(to_do, out, limits, jobWork(options, plan, limits, progress), ledger);
    progress.end();
    if (signal == 0) {
        removeOldRecords(out);
        return {0, tellBatch(options, ledger)};
    }
    tell("{}: stopped by a signal; --resume goes on with it", out.string());
    return {signal, kBadInput};
}

int runAndEnd(const BatchOptions& options) {
    const auto [signal, exit_code] = runBatch(options);
    if (signal != 0) endBy(signal);
    return exit_code;
}

std::vector<BatchRow> readRows(const fs::path& out) {
    std::error_code ignored;
    if (!fs::exists(ledgerFile(out), ignored))
        throw Error(ErrorCode::FileUnreadable, out.string(), "holds no batch");
    return rowsOf(Ledger::forReading(ledgerFile(out)), out);
}

/// What came of the parts so far, and which have no plan.
int tellStatus(const fs::path& out) {
    const std::vector<BatchRow> rows = readRows(out);
    const std::vector<Outcome> outcomes = outcomesOf(rows);
    printOut(fmt::format("{} parts: {}\n", rows.size(), countWords(outcomes)));
    for (const BatchRow& row : rows)
        if (!hasPlan(row.outcome) && row.outcome != Outcome::Waiting)
            printOut(fmt::format("{}: {}: {}\n", plainLine(row.part.name), toString(row.outcome),
                                 plainLine(row.reason)));
    return exitCodeOf(outcomes);
}

/// In which order the parts are best made with the tools of their plans.
void tellOrder(const fs::path& out, const std::vector<BatchRow>& rows, int places) {
    const PlannedTools planned = plannedTools(rows);
    const PartOrder order = orderParts(planned.tools, places);
    writeFile(out / "order.csv", orderCsv(rows, planned, order));
    printOut(fmt::format("Parts in order: {}\n  {}", (out / "order.csv").string(), orderText(order)));
}

/// Which tools serve all planned parts best in one magazine.
int tellMagazine(const fs::path& out, const MagazineTerms& terms) {
    const std::vector<BatchRow> rows = readRows(out);
    const Magazine magazine = bestMagazine(toolTasksOf(rows), terms);
    writeFile(out / "magazine.csv", magazineCsv(magazine));
    printOut(magazineText(magazine));
    printOut(fmt::format("What each tool is worth: {}\n", (out / "magazine.csv").string()));
    if (terms.places > 0) tellOrder(out, rows, terms.places);
    return magazine.unserved == 0 ? kComplete : kGaps;
}

/// Where a batch is looked at, not run.
struct BatchLook {
    std::string status;    ///< the batch's folder; empty: not asked for
    std::string magazine;  ///< the same
    MagazineTerms terms;
};

/// What a job of Slurm's does on a node: folder of a round; empty: not asked for.
struct OnNode {
    std::string task;
    std::string collect;
};

/// Slurm tells a task its number.
int runTaskOfSlurm(const std::string& round_folder) {
    const char* number = std::getenv("SLURM_ARRAY_TASK_ID");
    if (number == nullptr) throw Error(ErrorCode::Usage, "--task", "is for tasks of an array of Slurm's");
    return runTask(round_folder, std::atoi(number));
}

int runBatchCommand(const CLI::App& command, BatchOptions options, const BatchLook& look,
                    const OnNode& on_node) {
    if (!on_node.task.empty()) return runTaskOfSlurm(on_node.task);
    if (!on_node.collect.empty()) return collectRound(on_node.collect);
    if (!look.status.empty()) return tellStatus(look.status);
    if (!look.magazine.empty()) return tellMagazine(look.magazine, look.terms);
    if (options.source.empty() || options.out_dir.empty())
        throw Error(ErrorCode::Usage, "batch", "expected a folder or a list, and -o OUT; or --status OUT");
    options.plan = optionWords(command);
    options.resume = options.resume || options.retry;
    if (options.at_once == 0) options.at_once = options.on_slurm ? 1 : cores();
    if (command.get_option("--memory")->empty()) options.limits.memory_gb = defaultMemoryGb(options.at_once);
    return options.on_slurm ? submitBatch(options) : runAndEnd(options);
}

void addLookOptions(CLI::App& batch, BatchLook& look) {
    batch.add_option("--status", look.status, "print how far the batch in this folder is")->type_name("OUT");
    batch
        .add_option("--magazine", look.magazine,
                    "find the tools that serve all planned parts of the batch in this folder best")
        ->type_name("OUT");
    batch.add_option("--places", look.terms.places, "places of that magazine; 0: as many as tools")
        ->check(numberFrom(0, 1000, ""));
    batch
        .add_option("--load-tool", look.terms.load_cost,
                    "what it takes to put a tool in: seconds, or money where parts are planned for the least "
                    "cost")
        ->check(numberFrom(0, 1e6, ""));
}

void addClusterOptions(CLI::App& batch, BatchOptions& options, OnNode& on_node) {
    batch.add_flag("--slurm", options.on_slurm,
                   "let the nodes of a Slurm cluster plan the parts; all of them share SOURCE and OUT");
    batch.add_option("--partition", options.slurm.partition, "of the cluster");
    batch
        .add_option("--sbatch", options.slurm.more, "a word for sbatch, for example --sbatch=--account=shop")
        ->type_name("WORD")
        ->expected(1)
        ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    batch.add_option("--task-seconds", options.task_s, "what a task is to take; small parts share one")
        ->check(numberFrom(0.1, 1e6, "s"))
        ->capture_default_str();
    batch.add_option("--task", on_node.task)->group("");
    batch.add_option("--collect", on_node.collect)->group("");
}

}  // namespace

void addBatchCommand(CLI::App& app, int& exit_code) {
    CLI::App* batch = app.add_subcommand(
        "batch",
        "Plan every STEP file of a folder or a list, each by itself; whatever a part does, the "
        "others are planned");
    auto options = std::make_shared<BatchOptions>();
    auto look = std::make_shared<BatchLook>();
    auto on_node = std::make_shared<OnNode>();
    auto plan = std::make_shared<PlanOptions>();  // its words are read part by part
    batch->add_option("SOURCE", options->source,
                      "folder, with all below it; or a CSV list with the columns file, material, quantity, "
                      "due, options");
    batch->add_option("-o,--output", options->out_dir, "folder of the batch");
    batch->add_flag("--resume", options->resume,
                    "go on with the batch in that folder: what is planned stays, unless part, options or "
                    "program changed");
    batch->add_flag("--retry", options->retry,
                    "the same, and plan again what limits of time and memory, crashes and bugs ended");
    addLookOptions(*batch, *look);
    batch
        ->add_option("--jobs", options->at_once,
                     "parts at once; 0: one per core. With --slurm: at once in each task; 0: one")
        ->check(numberFrom(0, 1024, ""));
    addClusterOptions(*batch, *options, *on_node);
    addLimitOptions(*batch, options->limits);
    addPlanningOptions(*batch, *plan);
    addOfferOptions(*batch, *plan);
    batch->add_option("--fault", options->faults)->group("");
    batch->footer(
        "--timeout and --memory hold for each part; memory by default is shared by the parts at once.\n"
        "Exit codes: 0 all parts complete; 1 some with gaps or without a plan; 2 usage; 3 a bug in some "
        "part.\n"
        "Examples:\n"
        "  stepmill batch parts -o night\n"
        "  stepmill batch parts -o night --resume\n"
        "  stepmill batch orders.csv -o orders --material steel --jobs 8\n"
        "  stepmill batch parts -o night --buy catalogue.json\n"
        "  stepmill batch parts -o /shared/night --slurm --partition cpu\n"
        "  stepmill batch --status night\n"
        "  stepmill batch --magazine night --places 16 --load-tool 120");
    batch->callback([batch, options, plan, look, on_node, &exit_code] {
        exit_code = runBatchCommand(*batch, *options, *look, *on_node);
    });
}

}  // namespace stepmill
