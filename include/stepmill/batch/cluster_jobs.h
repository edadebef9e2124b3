#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/batch/job_record.h"
#include "stepmill/batch/ledger.h"
#include "stepmill/batch/run_jobs.h"
#include "stepmill/core/scratch_folder.h"

namespace stepmill {

/// What planning a part takes on one core, as far as its file tells, by its faces and its size. Of the
/// corpus' parts half are within a factor of two of it, and nine of ten within seven: enough to share work
/// out, no promise.
/// \param step  the file's text
double expectedSeconds(std::string_view step);

/// Shares jobs out among as few tasks as keep to a length, so that the longest is as short as can be had
/// quickly: the longest job first, each to the task that has least so far. Same input, same tasks.
/// \param expected_s  of each job
/// \param task_s      what a task is to take; a job that takes longer has a task of its own
/// \param most        tasks, at least 1
/// \return of each task its jobs' places, in the list's order; none is empty
std::vector<std::vector<std::size_t>> shareOut(const std::vector<double>& expected_s, double task_s,
                                               std::size_t most);

/// Enters jobs in records that the collecting task reads: a task never touches the ledger.
class TaskBook : public JobBook {
  public:
    /// \param node  that the task runs on
    TaskBook(std::filesystem::path batch, std::string node);
    void begin(const BatchJob& job) override;
    void finish(const BatchJob& job) override;

  private:
    std::filesystem::path batch_;
    std::string node_;
};

/// How a job stands that tasks were given: its outcome where one was recorded and, if it has a plan, that
/// plan is there; Outcome::Waiting else. `node` is where it was tried last; empty: nowhere yet.
TaskRecord recordedJob(const std::filesystem::path& batch, const BatchJob& job);

/// The ledger of a batch whose folder several machines share. SQLite's locks and its log are not for network
/// file systems: the ledger is worked on in a copy on this machine, and takes its place whole.
class SharedLedger {
  public:
    /// Copies the ledger, or begins one.
    /// \pre the batch's folder is locked
    /// \throws what Ledger does; Error(OutputUnwritable)
    explicit SharedLedger(std::filesystem::path file);
    /// Removes the copy.
    ~SharedLedger();
    SharedLedger(const SharedLedger&) = delete;
    SharedLedger& operator=(const SharedLedger&) = delete;

    Ledger& ledger();
    /// Puts the copy in the ledger's place.
    /// \throws Error(OutputUnwritable)
    void publish();

  private:
    std::filesystem::path file_;
    ScratchFolder folder_;  ///< of the copy
    std::unique_ptr<Ledger> copy_;
};

}  // namespace stepmill
