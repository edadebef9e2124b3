#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "stepmill/core/disk.h"
#include "stepmill/job/job_folder.h"
#include "stepmill/job/manifest.h"

namespace stepmill::job {

/// A job in place of another.
struct Replacement {
    Manifest manifest;              ///< of the new job, with the files that stay
    std::vector<NewFile> files;     ///< to be written
    std::vector<std::string> gone;  ///< files and folders of the old job that go, or that new ones replace
    std::vector<std::string> stay;  ///< files that stay: of the old job, and the user's
};

/// Writes the new job beside the folder and lets the two change places; the folder may be absent.
/// \return false, with nothing changed, where the system cannot do that here
/// \throws Error(OutputUnwritable), with nothing changed
bool replaceAtOnce(const std::filesystem::path& job, const Replacement& with, Disk& disk);

/// Writes the new job into a folder inside and moves file by file, the manifest first out and last in. Does
/// not touch files that stay.
/// \throws Error(OutputUnwritable), with nothing changed
void replaceOneByOne(const std::filesystem::path& job, const Replacement& with, Disk& disk);

}  // namespace stepmill::job
