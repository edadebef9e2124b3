#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "batch_list.h"
#include "batch_options.h"

namespace stepmill {

/// What one task on a cluster is to do.
struct ClusterTask {
    BatchOptions options;  ///< of the batch; of one that was read, what a task needs
    std::string program;   ///< the build that listed the parts: no other plans them
    std::vector<BatchJob> jobs;
    std::map<std::string, BatchPlan::Source> sources;  ///< of the jobs, by key's text
};

/// Where the tasks of a round find what they are to do. A batch has one round, and a second for what the
/// first has left.
std::filesystem::path roundFolder(const std::filesystem::path& batch, int round);
/// The reverse.
std::filesystem::path batchOfRound(const std::filesystem::path& round_folder);
int numberOfRound(const std::filesystem::path& round_folder);
/// Folder of what tasks print, for whoever looks for a cause.
std::filesystem::path toldFolder(const std::filesystem::path& batch);

/// Writes the tasks of a round, numbered from 0.
/// \throws Error(OutputUnwritable)
void writeTasks(const std::filesystem::path& round_folder, const std::vector<ClusterTask>& tasks);
/// \throws Error(FileUnreadable)
ClusterTask readTask(const std::filesystem::path& round_folder, std::size_t number);
/// All, by number.
/// \throws Error(FileUnreadable)
std::vector<ClusterTask> readTasks(const std::filesystem::path& round_folder);

/// Under which Slurm knows the jobs of this batch.
std::string slurmName(const std::filesystem::path& batch);

/// Removes rounds whose tasks have all ended, and what these told.
/// \pre the batch's folder is locked
/// \throws Error(Usage) where some wait or run, or Slurm does not say
void endOldRounds(const std::filesystem::path& batch);

}  // namespace stepmill
