#pragma once

#include <filesystem>

#include "batch_options.h"

namespace stepmill {

/// Hands what is to be planned to Slurm: an array of tasks, and a job that collects what they recorded.
/// Returns the exit code: 0 submitted, or as every batch where nothing is left to do.
int submitBatch(const BatchOptions& options);

/// On a node: plans the parts of one task of a round.
/// \param number  from 0
int runTask(const std::filesystem::path& round_folder, int number);

/// On a node, once all tasks of a round have ended: enters in the ledger what they recorded. What the first
/// round has left is submitted once more, to be tried on other nodes; what the second has left is entered as
/// killed.
int collectRound(const std::filesystem::path& round_folder);

}  // namespace stepmill
