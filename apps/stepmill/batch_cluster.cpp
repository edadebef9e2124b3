#include "batch_cluster.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include <unistd.h>

#include <fmt/format.h>

#include "batch_folder.h"
#include "batch_work.h"
#include "cluster_folder.h"
#include "commands.h"
#include "output.h"
#include "run.h"
#include "slurm.h"
#include "stepmill/batch/cluster_jobs.h"
#include "stepmill/batch/tidy_batch.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

namespace stepmill {

namespace fs = std::filesystem;

namespace {

constexpr int kRounds = 2;
/// Slurm's own limit of an array's tasks, unless a cluster says otherwise (MaxArraySize).
constexpr std::size_t kMostTasks = 1000;

/// What a task takes beside the memory of its parts: the process that watches over them.
constexpr std::uint64_t kWatchingMb = 256;

/// What the collecting job takes for each part of the batch: twice what was measured [docs/batch.md].
constexpr double kCollectingMbPerPart = 0.02;

/// Tasks that are kept from the same nodes.
struct TaskGroup {
    std::string without;  ///< nodes
    std::vector<ClusterTask> tasks;
};

SlurmJob slurmJob(const fs::path& round_folder, const ClusterTask& any) {
    const fs::path batch = batchOfRound(round_folder);
    constexpr double kMbPerGb = 1024;
    SlurmJob job;
    job.name = slurmName(batch);
    job.options = any.options.slurm;
    job.cpus = any.options.at_once;
    job.memory_mb =
        kWatchingMb +
        static_cast<std::uint64_t>(std::ceil(kMbPerGb * any.options.limits.memory_gb * any.options.at_once));
    job.script = round_folder / "run.sh";
    job.words = {fs::read_symlink("/proc/self/exe").string(), "batch"};
    job.told = toldFolder(batch);
    return job;
}

/// Where all other nodes are gone or not of the partition, the same node is better than none.
std::string submitWherePossible(SlurmJob job) {
    try {
        return submitToSlurm(job);
    } catch (const Error&) {
        if (job.without.empty()) throw;
        job.without.clear();
        return submitToSlurm(job);
    }
}

/// \return the array's number
std::string submitTasks(const fs::path& round_folder, const TaskGroup& group, std::size_t first) {
    SlurmJob job = slurmJob(round_folder, group.tasks.front());
    job.tasks = fmt::format("{}-{}", first, first + group.tasks.size() - 1);
    job.without = group.without;
    job.words.insert(job.words.end(), {"--task", round_folder.string()});
    return submitWherePossible(job);
}

/// \param parts  of the whole batch
/// \return the job's number
std::string submitCollecting(const fs::path& round_folder, const ClusterTask& any,
                             const std::vector<std::string>& arrays, std::size_t parts) {
    SlurmJob job = slurmJob(round_folder, any);
    job.cpus = 1;
    job.memory_mb =
        kWatchingMb + static_cast<std::uint64_t>(kCollectingMbPerPart * static_cast<double>(parts));
    job.after = arrays;
    job.again_where_lost = true;
    job.words.insert(job.words.end(), {"--collect", round_folder.string()});
    return submitToSlurm(job);
}

void makeRound(const fs::path& round_folder, const std::vector<TaskGroup>& groups) {
    std::vector<ClusterTask> all;
    for (const TaskGroup& group : groups)
        all.insert(all.end(), group.tasks.begin(), group.tasks.end());
    writeTasks(round_folder, all);
    writeFile(round_folder / "run.sh", "#!/bin/sh\nexec \"$@\"\n");
    std::error_code why;
    fs::create_directories(toldFolder(batchOfRound(round_folder)), why);
    if (why) throw Error(ErrorCode::OutputUnwritable, round_folder.string(), why.message());
}

/// \param parts  of the whole batch
/// \pre some group has tasks
void submitRound(const fs::path& round_folder, const std::vector<TaskGroup>& groups, std::size_t parts) {
    makeRound(round_folder, groups);
    std::vector<std::string> arrays;
    std::size_t first = 0;
    for (const TaskGroup& group : groups) {
        arrays.push_back(submitTasks(round_folder, group, first));
        first += group.tasks.size();
    }
    const std::string collecting =
        submitCollecting(round_folder, groups.front().tasks.front(), arrays, parts);
    printOut(
        fmt::format("Submitted to Slurm: {} tasks (jobs {}), then one that collects what they did ({})\n",
                    first, fmt::join(arrays, ", "), collecting));
}

/// The jobs to do, shared out.
TaskGroup firstTasks(const BatchOptions& options, const BatchPlan& plan, const std::vector<BatchJob>& to_do) {
    std::vector<double> expected_s;
    expected_s.reserve(to_do.size());
    for (const BatchJob& job : to_do)
        expected_s.push_back(plan.sources.at(job.key.text()).expected_s / options.at_once);
    TaskGroup group;
    for (const std::vector<std::size_t>& share : shareOut(expected_s, options.task_s, kMostTasks)) {
        ClusterTask task{options, to_do[share.front()].key.program, {}, {}};
        for (const std::size_t at : share) {
            const std::string key = to_do[at].key.text();
            task.jobs.push_back(to_do[at]);
            task.sources[key] = plan.sources.at(key);
        }
        group.tasks.push_back(std::move(task));
    }
    return group;
}

/// What came of the jobs of a round's tasks.
class Collected {
  public:
    Collected(fs::path round_folder) : round_(std::move(round_folder)), batch_(batchOfRound(round_)) {
        for (const ClusterTask& task : readTasks(round_))
            take(task);
    }

    const std::vector<BatchJob>& done() const { return done_; }
    const std::vector<TaskGroup>& again() const { return again_; }

  private:
    bool isLast() const { return numberOfRound(round_) == kRounds; }

    void take(const ClusterTask& task) {
        std::vector<TaskRecord> left;
        for (const BatchJob& job : task.jobs) {
            TaskRecord record = recordedJob(batch_, job);
            if (isLast() || !isDoneAgain(record.job.outcome, false))
                done_.push_back(ended(std::move(record)));
            else
                left.push_back(std::move(record));
        }
        if (!left.empty()) addAgain(task, left);
    }

    /// A job that has no outcome now never will.
    static BatchJob ended(TaskRecord record) {
        BatchJob job = std::move(record.job);
        if (job.outcome != Outcome::Waiting) return job;
        job.outcome = Outcome::Killed;
        job.exit_code = kBadInput;
        job.message =
            fmt::format("its task on the cluster ended before it was planned, and so did a second, on {}\n",
                        record.node.empty() ? "no node" : record.node);
        return job;
    }

    /// The same task with what it has left, kept from the nodes where that was tried. What was under way when
    /// the task ended may be why it did: that comes last.
    void addAgain(const ClusterTask& task, std::vector<TaskRecord>& left) {
        std::stable_partition(left.begin(), left.end(),
                              [](const TaskRecord& record) { return record.node.empty(); });
        ClusterTask again{task.options, task.program, {}, {}};
        std::set<std::string> nodes;
        for (TaskRecord& record : left) {
            record.job.outcome = Outcome::Waiting;
            const std::string key = record.job.key.text();
            again.sources[key] = task.sources.at(key);
            again.jobs.push_back(std::move(record.job));
            if (!record.node.empty()) nodes.insert(record.node);
        }
        groupWithout(fmt::format("{}", fmt::join(nodes, ","))).tasks.push_back(std::move(again));
    }

    TaskGroup& groupWithout(const std::string& nodes) {
        for (TaskGroup& group : again_)
            if (group.without == nodes) return group;
        again_.push_back({nodes, {}});
        return again_.back();
    }

    fs::path round_;
    fs::path batch_;
    std::vector<BatchJob> done_;
    std::vector<TaskGroup> again_;
};

/// Enters what earlier tasks have recorded and nobody collected; what is left begins.
std::vector<BatchJob> beginJobs(const fs::path& out, const std::vector<BatchJob>& to_do, Ledger& ledger) {
    std::vector<BatchJob> left;
    std::vector<BatchJob> known;
    for (const BatchJob& job : to_do) {
        BatchJob recorded = recordedJob(out, job).job;
        if (recorded.outcome == Outcome::Waiting)
            left.push_back(job);
        else
            known.push_back(std::move(recorded));
    }
    for (const BatchJob& job : left)
        ledger.begin(job);
    ledger.finish(known);
    return left;
}

std::string nodeName() {
    if (const char* node = std::getenv("SLURMD_NODENAME")) return node;
    constexpr std::size_t kLongest = 256;
    std::string name(kLongest, '\0');
    ::gethostname(name.data(), name.size() - 1);
    return name.c_str();
}

JobWork taskWork(const ClusterTask& task, const BatchPlan& plan) {
    constexpr int kThreads = 1;  // each part has one of the task's processors
    return {[&task, &plan](const BatchJob& job, JobFolder& folder, StageBoard& board) {
                return planBatchJob(task.options, plan, job, kThreads, folder, board);
            },
            [&task](const Supervised& end) { return endWords(end, task.options.limits).text; },
            [](const BatchJob& job) {
                printOut(fmt::format("{} {} {:.1f} s\n", toString(job.outcome), job.folder, job.seconds));
                flushOut();
            }};
}

}  // namespace

int submitBatch(const BatchOptions& options) {
    const BatchPlan plan = listBatch(options, programIdentity());
    const fs::path out = options.out_dir;
    const std::unique_ptr<FolderLock> lock = takeBatchFolder(options);
    tidyBatch(out);
    SharedLedger shared(ledgerFile(out));
    shared.ledger().setParts(plan.parts);
    const std::vector<BatchJob> left =
        beginJobs(out, jobsToDo(plan, options, shared.ledger()), shared.ledger());
    shared.publish();
    if (left.empty()) return tellBatch(options, shared.ledger());
    submitRound(roundFolder(out, 1), {firstTasks(options, plan, left)}, plan.parts.size());
    printOut(
        fmt::format("How far it is: stepmill batch --status {0}; its end: {0}/index.html\n", out.string()));
    return kComplete;
}

int runTask(const fs::path& round_folder, int number) {
    const ClusterTask task = readTask(round_folder, static_cast<std::size_t>(number));
    const std::string program = programIdentity();
    if (program != task.program)
        throw Error(ErrorCode::Usage, "task",
                    fmt::format("is for Stepmill {}, and this is {}", task.program, program));
    BatchPlan plan;
    plan.sources = task.sources;
    const std::string node = nodeName();
    printOut(fmt::format("{}: {} parts\n", node, task.jobs.size()));
    TaskBook book(task.options.out_dir, node);
    const int signal = runJobs(task.jobs, task.options.out_dir, jobLimits(task.options, task.options.at_once),
                               taskWork(task, plan), book);
    if (signal != 0) endBy(signal);
    return kComplete;
}

int collectRound(const fs::path& round_folder) {
    const fs::path out = batchOfRound(round_folder);
    const std::unique_ptr<FolderLock> lock = lockBatch(out);
    tidyBatch(out);
    const Collected collected(round_folder);
    SharedLedger shared(ledgerFile(out));
    shared.ledger().finish(collected.done());
    shared.publish();
    for (const BatchJob& job : collected.done())
        removeRecord(out, job);
    const std::vector<BatchRow> rows = rowsOf(shared.ledger());
    writeTables(out, rows);
    printOut(fmt::format("{} parts: {}\n", rows.size(), countWords(outcomesOf(rows))));
    std::error_code ignored;
    if (!collected.again().empty())
        submitRound(roundFolder(out, numberOfRound(round_folder) + 1), collected.again(), rows.size());
    else
        for (int round = 1; round <= kRounds; ++round)
            fs::remove_all(roundFolder(out, round), ignored);
    return kComplete;
}

}  // namespace stepmill
