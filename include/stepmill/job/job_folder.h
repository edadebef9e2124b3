#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stepmill/core/disk.h"
#include "stepmill/job/manifest.h"

namespace stepmill {

/// A file to be written.
struct NewFile {
    std::string name;
    std::string dialect;  ///< of a program; empty for other files
    std::string bytes;
};

/// What one command writes into a job folder.
struct NewJob {
    JobWriter by = JobWriter::Plan;
    std::string part_file;
    std::string part_sha256;
    std::string plan_sha256;  ///< of the plan.json that the programs belong to; empty without one
    std::vector<NewFile> files;
    std::vector<std::string> solids;  ///< folders below, each a job of its own that is written already
};

/// A job folder in the hands of its one writer [docs/jobs.md]. It is locked against a second writer while
/// this object lives.
///
/// What a manifest of ours names is the job and goes when the job is replaced; all else in the folder is the
/// user's, and stays. A program that is not of the job is refused: a machine could load it.
class JobFolder {
  public:
    /// Locks the folder, makes folders on the way to it, and finishes or removes what a killed run left of
    /// its writing.
    /// \param dir  may be absent; a link to a folder stands for that folder
    /// \throws Error(OutputUnwritable) when another run has it, it is no folder, or it holds a program that
    ///         is not of its job; Error(InvalidCatalog) when its manifest is damaged
    explicit JobFolder(const std::filesystem::path& dir, Disk& disk = systemDisk());
    /// Tidies up after a child process that was killed while it wrote, and unlocks.
    ~JobFolder();
    JobFolder(const JobFolder&) = delete;
    JobFolder& operator=(const JobFolder&) = delete;

    const std::filesystem::path& path() const;

    /// Writes a job, in place of what it replaces:
    /// - a plan replaces the whole job; pages of inspect and curves stay when they are of the same part;
    /// - post replaces programs of its dialect, and where the folder has no plan all of another plan;
    /// - inspect and curves replace their own pages, and where the folder has no plan those of another part.
    ///
    /// All is written and on the disk beside the folder first; then the folders change places at once. Where
    /// they cannot (it is the current folder, a mount point, holds folders, the file system has no such call)
    /// the files move one by one, the manifest first out and last in: a folder without it is no job, and the
    /// next run puts the old job back.
    /// \throws Error(OutputUnwritable): the folder then holds what it held
    void write(const NewJob& job);

    /// Files of the job that had been changed since they were written and were replaced by write().
    const std::vector<std::string>& replacedEdits() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Tidies up what killed runs left of their writing into folders below `dir`.
void tidyFoldersBelow(const std::filesystem::path& dir);

/// How a folder differs from what was written there.
struct JobCheck {
    bool has_manifest = false;
    std::vector<std::string> changed;   ///< files that are not as they were written
    std::vector<std::string> missing;   ///< files that are gone
    std::vector<std::string> programs;  ///< programs that the manifest does not name; all without one
};

/// Looks through a job folder.
/// \throws Error(FileUnreadable) for a folder whose writing was not finished; what readManifest throws
JobCheck checkJob(const std::filesystem::path& dir);

}  // namespace stepmill
