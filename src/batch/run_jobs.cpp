#include "stepmill/batch/run_jobs.h"

#include <chrono>
#include <ctime>
#include <list>
#include <memory>

#include "batch/job_run.h"
#include "stepmill/core/error.h"

namespace stepmill {

namespace fs = std::filesystem;

namespace {

using batch::JobRun;

/// How long the supervisor sleeps between two looks at its children.
constexpr std::chrono::milliseconds kPause{5};

std::string nowInUtc() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::gmtime_r(&now, &parts);
    std::array<char, 32> text{};
    return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

class Runner {
  public:
    Runner(const fs::path& batch, const JobLimits& limits, const JobWork& work, JobBook& book)
        : batch_(batch), limits_(limits), work_(work), book_(book) {}

    int run(const std::vector<BatchJob>& jobs) {
        auto next = jobs.begin();
        while (next != jobs.end() || !running_.empty()) {
            while (next != jobs.end() && static_cast<int>(running_.size()) < limits_.at_once)
                start(*next++);
            const auto pause = collect() ? std::chrono::milliseconds(0) : kPause;
            if (const int signal = stop_.waitFor(pause); signal != 0) return signal;
        }
        return 0;
    }

  private:
    void start(BatchJob job) {
        ++job.tries;
        job.started = nowInUtc();
        if (const std::optional<BatchJob> planned = plannedJob(batch_, job)) return enter(*planned);
        book_.begin(job);
        try {
            running_.push_back(std::make_unique<JobRun>(job, batch_, limits_.each, work_, stop_));
        } catch (const Error& error) {
            if (error.code() == ErrorCode::SystemLimit) throw;
            job.outcome = Outcome::Unwritable;
            job.exit_code = 2;
            job.message = error.what();
            enter(job);
        }
    }

    /// Has any of them ended?
    bool collect() {
        const std::size_t before = running_.size();
        for (auto run = running_.begin(); run != running_.end();) {
            if (const std::optional<BatchJob> job = (*run)->ended()) {
                run = running_.erase(run);
                enter(*job);
            } else {
                ++run;
            }
        }
        return running_.size() < before;
    }

    void enter(const BatchJob& job) {
        book_.finish(job);
        work_.done(job);
    }

    const fs::path& batch_;
    const JobLimits& limits_;
    const JobWork& work_;
    JobBook& book_;
    const StopSignals stop_;
    std::list<std::unique_ptr<JobRun>> running_;
};

class LedgerBook : public JobBook {
  public:
    LedgerBook(Ledger& ledger, const fs::path& batch) : ledger_(ledger), batch_(batch) {}
    void begin(const BatchJob& job) override { ledger_.begin(job); }
    void finish(const BatchJob& job) override {
        ledger_.finish(job);
        removeRecord(batch_, job);
    }

  private:
    Ledger& ledger_;
    const fs::path& batch_;
};

}  // namespace

bool isPlanned(const fs::path& batch, const BatchJob& job) {
    std::error_code ignored;
    return fs::exists(jobFolder(batch, job) / kManifestName, ignored);
}

int runJobs(const std::vector<BatchJob>& jobs, const fs::path& batch, const JobLimits& limits,
            const JobWork& work, JobBook& book) {
    return Runner(batch, limits, work, book).run(jobs);
}

int runJobs(const std::vector<BatchJob>& jobs, const fs::path& batch, const JobLimits& limits,
            const JobWork& work, Ledger& ledger) {
    LedgerBook book(ledger, batch);
    return runJobs(jobs, batch, limits, work, book);
}

std::optional<BatchJob> plannedJob(const fs::path& batch, BatchJob job) {
    const std::optional<JobRecord> record = readRecord(batch, job);
    if (!record) return std::nullopt;
    job.outcome = batch::outcomeOfExit(record->exit_code);
    job.exit_code = record->exit_code;
    job.figures = record->figures;
    return job;
}

}  // namespace stepmill
