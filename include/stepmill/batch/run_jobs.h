#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/batch/job_record.h"
#include "stepmill/batch/ledger.h"
#include "stepmill/core/supervise.h"
#include "stepmill/job/job_folder.h"

namespace stepmill {

/// Exit codes of a job's process beside those of every command.
enum JobExit : int {
    kExitUnwritable = 4,  ///< its results could not be written
    kExitMissing = 5,     ///< the file could not be read
    kExitChanged = 6      ///< the file is not the one that was listed
};

/// What the caller does for each job.
struct JobWork {
    /// In the job's own process: plans its part into the folder, writes its record (job_record.h), and
    /// returns 0 complete, 1 gaps, 2 refused, 3 a bug, or a JobExit.
    std::function<int(const BatchJob& job, JobFolder& folder, StageBoard& board)> plan;
    /// What ended the process otherwise, for people.
    std::function<std::string(const Supervised& end)> end_words;
    /// Told of each job when its turn is over.
    std::function<void(const BatchJob& job)> done;
};

struct JobLimits {
    int at_once = 1;        ///< jobs
    SupervisedLimits each;  ///< of a job's process
};

/// Is there a whole job in its folder?
bool isPlanned(const std::filesystem::path& batch, const BatchJob& job);

/// Where it is entered what came of each job. What a call has entered stays whatever ends the program.
class JobBook {
  public:
    virtual ~JobBook() = default;
    /// A job's turn has come.
    /// \throws Error(OutputUnwritable), as does finish()
    virtual void begin(const BatchJob& job) = 0;
    /// Its turn is over.
    virtual void finish(const BatchJob& job) = 0;
};

/// Plans jobs, several at once, each in a supervised process of its own, and enters in the book what came
/// of each. Whatever a job does, the others are not harmed. Jobs that a killed run had planned, but not
/// entered, are entered alone.
/// \return the signal that stopped it; 0 when all have had their turn
/// \throws Error(OutputUnwritable) where the book cannot be written, Error(SystemLimit): jobs under way are
///         ended
/// \pre no other thread runs
int runJobs(const std::vector<BatchJob>& jobs, const std::filesystem::path& batch, const JobLimits& limits,
            const JobWork& work, JobBook& book);

/// The same with the ledger as the book.
int runJobs(const std::vector<BatchJob>& jobs, const std::filesystem::path& batch, const JobLimits& limits,
            const JobWork& work, Ledger& ledger);

/// The job with the outcome that its own process recorded, whatever ended the run above it; nothing where
/// there is no such record, or the job's folder does not hold that plan.
std::optional<BatchJob> plannedJob(const std::filesystem::path& batch, BatchJob job);

}  // namespace stepmill
