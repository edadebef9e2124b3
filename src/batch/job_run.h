#pragma once

#include <optional>

#include "stepmill/batch/run_jobs.h"

namespace stepmill::batch {

/// A file without a name that takes what a child process tells, and gives it back when the child has ended.
class Whispers {
  public:
    /// \throws Error(SystemLimit)
    Whispers();
    ~Whispers();
    Whispers(const Whispers&) = delete;
    Whispers& operator=(const Whispers&) = delete;

    /// In the child: standard error goes here, standard output nowhere.
    void takeStreams() const;
    /// All that was told, cut where it is too long for a book.
    std::string text() const;

  private:
    int file_;
};

/// A job that is being planned.
class JobRun {
  public:
    /// \throws Error(OutputUnwritable) where the job's folder cannot be had; Error(SystemLimit)
    JobRun(BatchJob job, const std::filesystem::path& batch, const SupervisedLimits& limits,
           const JobWork& work, const StopSignals& stop);

    /// The job with what came of it; nothing while it works.
    std::optional<BatchJob> ended();

  private:
    BatchJob finished(const Supervised& end) const;

    BatchJob job_;
    std::filesystem::path batch_;
    const JobWork& work_;
    Whispers whispers_;
    JobFolder folder_;
    SupervisedChild child_;  ///< ends before the folder is tidied
};

/// What an exit code of a job's process says.
Outcome outcomeOfExit(int exit_code);

}  // namespace stepmill::batch
