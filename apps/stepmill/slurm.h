#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace stepmill {

/// How the shop's cluster wants its jobs, as typed.
struct SlurmOptions {
    std::string partition;          ///< empty: the cluster's default
    std::vector<std::string> more;  ///< words for sbatch ("--account=shop")
};

/// A job for Slurm: one process, or an array of tasks of one process each.
struct SlurmJob {
    std::string name;
    SlurmOptions options;
    std::string tasks;               ///< of an array, "0-11"; empty: no array
    std::vector<std::string> after;  ///< jobs that must have ended, however they did
    std::string without;             ///< nodes that it is kept from, "node1,node2"
    int cpus = 1;                    ///< of each task
    std::uint64_t memory_mb = 0;     ///< of each task
    bool again_where_lost = false;   ///< Slurm begins it again where a node is lost
    std::filesystem::path script;    ///< what a node runs
    std::vector<std::string> words;  ///< handed to the script
    std::filesystem::path told;      ///< folder of what the tasks print
};

/// Hands the job to Slurm's own client (sbatch), to run in the current folder.
/// \return its number
/// \throws Error(Usage) with sbatch's words where it is not taken, or there is no Slurm here
std::string submitToSlurm(const SlurmJob& job);

/// Jobs of this user and name that wait or run.
/// \throws Error(Usage) where Slurm (squeue) does not say
std::vector<std::string> slurmJobsNamed(const std::string& name);

}  // namespace stepmill
