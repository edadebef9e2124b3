#include "stepmill/batch/cluster_jobs.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

#include <unistd.h>

#include <fmt/format.h>

#include "stepmill/core/error.h"

namespace stepmill {

namespace fs = std::filesystem;

namespace {

std::size_t countOf(std::string_view text, std::string_view word) {
    std::size_t count = 0;
    for (std::size_t at = text.find(word); at != std::string_view::npos;
         at = text.find(word, at + word.size()))
        ++count;
    return count;
}

/// Jobs by what they take, longest first.
std::vector<std::size_t> longestFirst(const std::vector<double>& expected_s) {
    std::vector<std::size_t> order(expected_s.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return expected_s[a] > expected_s[b]; });
    return order;
}

std::size_t tasksFor(const std::vector<double>& expected_s, double task_s, std::size_t most) {
    const double all_s = std::accumulate(expected_s.begin(), expected_s.end(), 0.0);
    const auto wanted = static_cast<std::size_t>(std::ceil(all_s / task_s));
    return std::clamp<std::size_t>(wanted, 1, std::min(most, expected_s.size()));
}

}  // namespace

double expectedSeconds(std::string_view step) {
    constexpr double kEachS = 0.1;
    constexpr double kPerFaceSquaredS = 0.001;  // faces make features, and these look at each other
    constexpr double kPerMbS = 1;
    constexpr double kBytesPerMb = 1e6;
    const auto faces = static_cast<double>(countOf(step, "ADVANCED_FACE"));
    return kEachS + kPerFaceSquaredS * faces * faces +
           kPerMbS * static_cast<double>(step.size()) / kBytesPerMb;
}

std::vector<std::vector<std::size_t>> shareOut(const std::vector<double>& expected_s, double task_s,
                                               std::size_t most) {
    if (expected_s.empty()) return {};
    std::vector<std::vector<std::size_t>> tasks(tasksFor(expected_s, task_s, most));
    using Load = std::pair<double, std::size_t>;
    std::priority_queue<Load, std::vector<Load>, std::greater<>> least;
    for (std::size_t task = 0; task < tasks.size(); ++task)
        least.emplace(0, task);
    for (const std::size_t job : longestFirst(expected_s)) {
        const auto [load_s, task] = least.top();
        least.pop();
        tasks[task].push_back(job);
        least.emplace(load_s + expected_s[job], task);
    }
    for (std::vector<std::size_t>& task : tasks)
        std::sort(task.begin(), task.end());
    std::erase_if(tasks, [](const std::vector<std::size_t>& task) { return task.empty(); });
    return tasks;
}

TaskBook::TaskBook(fs::path batch, std::string node) : batch_(std::move(batch)), node_(std::move(node)) {}

void TaskBook::begin(const BatchJob& job) {
    BatchJob begun = job;
    begun.outcome = Outcome::Waiting;
    writeTaskRecord(batch_, {begun, node_});
}

void TaskBook::finish(const BatchJob& job) {
    writeTaskRecord(batch_, {job, node_});
}

TaskRecord recordedJob(const fs::path& batch, const BatchJob& job) {
    TaskRecord record = readTaskRecord(batch, job).value_or(TaskRecord{job, ""});
    const bool has_ended = record.job.outcome != Outcome::Waiting && !hasPlan(record.job.outcome);
    if (has_ended) return record;
    record.job.outcome = Outcome::Waiting;
    if (std::optional<BatchJob> planned = plannedJob(batch, record.job)) record.job = std::move(*planned);
    return record;
}

SharedLedger::SharedLedger(fs::path file) : file_(std::move(file)), folder_("ledger") {
    std::error_code why;
    const fs::path copy = folder_.path() / file_.filename();
    if (fs::exists(file_, why)) {
        Ledger::settle(file_);  // a run on one machine may have left a log
        if (!fs::copy_file(file_, copy, why))
            throw Error(ErrorCode::OutputUnwritable, copy.string(), why.message());
    }
    copy_ = std::make_unique<Ledger>(copy);
}

SharedLedger::~SharedLedger() = default;

Ledger& SharedLedger::ledger() {
    return *copy_;
}

void SharedLedger::publish() {
    copy_->settle();
    // Not read into memory: a million parts make a few gigabytes.
    const fs::path beside = fmt::format("{}.{}.part", file_.string(), ::getpid());
    std::error_code why;
    fs::copy_file(folder_.path() / file_.filename(), beside, fs::copy_options::overwrite_existing, why);
    if (!why) fs::rename(beside, file_, why);
    if (!why) return;
    std::error_code ignored;
    fs::remove(beside, ignored);
    throw Error(ErrorCode::OutputUnwritable, file_.string(), why.message());
}

}  // namespace stepmill
