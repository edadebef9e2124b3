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
    Runner(const fs::path& batch, const JobLimits& limits, const JobWork& work, Ledger& ledger)
        : batch_(batch), limits_(limits), work_(work), ledger_(ledger) {}

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
        if (const std::optional<JobRecord> record = readRecord(batch_, job)) return adopt(job, *record);
        ledger_.begin(job);
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

    /// A run that was killed had planned it, and the plan is there still.
    void adopt(BatchJob& job, const JobRecord& record) {
        job.outcome = batch::outcomeOfExit(record.exit_code);
        job.exit_code = record.exit_code;
        job.figures = record.figures;
        enter(job);
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
        ledger_.finish(job);
        removeRecord(batch_, job);
        work_.done(job);
    }

    const fs::path& batch_;
    const JobLimits& limits_;
    const JobWork& work_;
    Ledger& ledger_;
    const StopSignals stop_;
    std::list<std::unique_ptr<JobRun>> running_;
};

}  // namespace

bool isPlanned(const fs::path& batch, const BatchJob& job) {
    std::error_code ignored;
    return fs::exists(jobFolder(batch, job) / kManifestName, ignored);
}

int runJobs(const std::vector<BatchJob>& jobs, const fs::path& batch, const JobLimits& limits,
            const JobWork& work, Ledger& ledger) {
    return Runner(batch, limits, work, ledger).run(jobs);
}

}  // namespace stepmill
