#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "batch_list.h"
#include "stepmill/batch/batch_rows.h"
#include "stepmill/batch/run_jobs.h"
#include "stepmill/job/folder_lock.h"

namespace stepmill {

/// In the batch's folder.
std::filesystem::path ledgerFile(const std::filesystem::path& batch);

/// The batch's folder, locked, and fit for this run: it holds no batch, or one that is to go on.
/// \throws Error(OutputUnwritable) where another run has it, Error(Usage) where --resume was not said or
///         tasks on a cluster plan its parts
std::unique_ptr<FolderLock> takeBatchFolder(const BatchOptions& options);

/// The lock alone, for one who goes on with what the folder holds. What a killed batch was doing may need a
/// moment to end: its parts hold the lock until then.
std::unique_ptr<FolderLock> lockBatch(const std::filesystem::path& out);

/// Jobs that have no outcome yet, or one that is to be had again.
std::vector<BatchJob> jobsToDo(const BatchPlan& plan, const BatchOptions& options, const Ledger& ledger);

/// What each part may take.
JobLimits jobLimits(const BatchOptions& options, int at_once);

/// index.html, parts.csv and tools.csv.
void writeTables(const std::filesystem::path& out, const std::vector<BatchRow>& rows);

/// Writes the tables, prints counts, and returns the exit code.
int tellBatch(const BatchOptions& options, const Ledger& ledger);

}  // namespace stepmill
