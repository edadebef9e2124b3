#pragma once

#include <filesystem>

namespace stepmill {

/// Removes what a killed batch left half-written in its folder, of tables, records and job folders. Whole
/// records stay.
/// \pre the batch's folder is locked
void tidyBatch(const std::filesystem::path& batch);

/// Removes the records that no job asked for: of options that have changed since a killed run.
/// \pre the batch's folder is locked, and all its jobs are in the ledger
void removeOldRecords(const std::filesystem::path& batch);

}  // namespace stepmill
