#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/core/disk.h"
#include "stepmill/job/manifest.h"

namespace stepmill::job {

/// In a work folder inside the job folder: the files of the job that is being replaced. It is made when all
/// new files are complete, so that without it nothing has moved yet.
inline constexpr const char* kOldName = "old";

/// Something has that name; a link that leads nowhere too.
bool isThere(const std::filesystem::path& path);

/// "<parent>/.job.stepmill-": beside a job folder, what ours are called before six letters of chance.
std::filesystem::path besidePrefix(const std::filesystem::path& job);
/// "<job>/.stepmill-": the same inside it.
std::filesystem::path insidePrefix(const std::filesystem::path& job);

/// Makes a folder of a prefix and six letters of chance.
/// \throws Error(OutputUnwritable)
std::filesystem::path makeWorkFolder(const std::filesystem::path& prefix, Disk& disk);

/// Folders of a prefix and six more letters.
std::vector<std::filesystem::path> workFolders(const std::filesystem::path& prefix);

/// The folder's manifest if it has one that can be read.
std::optional<Manifest> manifestIfWhole(const std::filesystem::path& folder);

/// Removes a work folder with what is ours in it: files that its manifest names, and second names of files
/// that are in `job` too. Anything else stays, and with it the folder.
void removeWorkFolder(const std::filesystem::path& work, const std::filesystem::path& job, Disk& disk);

/// Puts the old job back where files were moving one by one and the new manifest was not there yet.
/// \throws Error(OutputUnwritable)
void undoMoves(const std::filesystem::path& work, const std::filesystem::path& job, Disk& disk);

/// undoMoves() and removeWorkFolder() for all that killed runs left of a job folder.
void tidyJob(const std::filesystem::path& job, Disk& disk);

}  // namespace stepmill::job
