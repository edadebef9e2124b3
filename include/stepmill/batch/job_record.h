#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "stepmill/batch/ledger.h"

namespace stepmill {

/// What the process that planned a job leaves for the one that keeps the ledger: a file below records/,
/// whole or not there. A batch that was killed in between takes it up when it goes on.
struct JobRecord {
    int exit_code = 0;
    std::string figures;  ///< figuresJson()
};

/// A job's folder in that of its batch.
std::filesystem::path jobFolder(const std::filesystem::path& batch, const BatchJob& job);

/// \param batch  the batch's folder
/// \throws Error(OutputUnwritable); Error(FileUnreadable) where the job's folder holds no job
void writeRecord(const std::filesystem::path& batch, const BatchJob& job, const JobRecord& record);

/// Nothing where there is none, or the job's folder does not hold the job that it was written for.
std::optional<JobRecord> readRecord(const std::filesystem::path& batch, const BatchJob& job);

/// What a task on a cluster leaves of a job for the one that keeps the ledger, beside the record of the
/// job's own process: how the job is just now, and where.
struct TaskRecord {
    BatchJob job;  ///< without its figures; Outcome::Waiting: begun, and perhaps under way
    std::string node;
};

/// Whole or not at all.
/// \throws Error(OutputUnwritable)
void writeTaskRecord(const std::filesystem::path& batch, const TaskRecord& record);

/// Nothing where the job has not begun in any task, or its last record is damaged. A job that is told to be
/// planned but whose plan is not there (plannedJob()) is one that has begun.
std::optional<TaskRecord> readTaskRecord(const std::filesystem::path& batch, const BatchJob& job);

/// All records of a job, once it stands in the ledger.
void removeRecord(const std::filesystem::path& batch, const BatchJob& job);

}  // namespace stepmill
