#include "cluster_folder.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "slurm.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

namespace stepmill {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::json;

fs::path clusterFolder(const fs::path& batch) {
    return batch / "cluster";
}

fs::path taskFile(const fs::path& round_folder, std::size_t number) {
    return round_folder / fmt::format("{}.cbor", number);
}

Json jsonOf(const BatchOptions& options) {
    return {{"timeout_s", options.limits.timeout_s},
            {"memory_gb", options.limits.memory_gb},
            {"max_file_mb", options.limits.max_file_mb},
            {"at_once", options.at_once},
            {"partition", options.slurm.partition},
            {"sbatch", options.slurm.more},
            {"faults", options.faults}};
}

BatchOptions optionsFrom(const Json& json) {
    BatchOptions options;
    options.limits.timeout_s = json.at("timeout_s");
    options.limits.memory_gb = json.at("memory_gb");
    options.limits.max_file_mb = json.at("max_file_mb");
    options.at_once = json.at("at_once");
    options.slurm.partition = json.at("partition");
    options.slurm.more = json.at("sbatch").get<std::vector<std::string>>();
    options.faults = json.at("faults").get<std::vector<std::string>>();
    return options;
}

Json jsonOf(const BatchJob& job, const BatchPlan::Source& source) {
    std::vector<std::string> files;
    for (const fs::path& file : source.files)
        files.push_back(file.string());
    return {{"part", job.key.part_sha256},
            {"told", job.key.options_sha256},
            {"folder", job.folder},
            {"tries", job.tries},
            {"files", files},
            {"options", source.options}};
}

void takeJob(const Json& json, ClusterTask& task) {
    BatchJob job;
    job.key = {json.at("part"), json.at("told"), task.program};
    job.folder = json.at("folder");
    job.tries = json.at("tries");
    BatchPlan::Source source;
    for (const std::string file : json.at("files"))
        source.files.emplace_back(file);
    source.options = json.at("options").get<OptionWords>();
    task.sources[job.key.text()] = std::move(source);
    task.jobs.push_back(std::move(job));
}

/// CBOR, since names of files are any bytes.
std::string bytesOf(const ClusterTask& task) {
    Json jobs = Json::array();
    for (const BatchJob& job : task.jobs)
        jobs.push_back(jsonOf(job, task.sources.at(job.key.text())));
    const Json json{{"program", task.program}, {"options", jsonOf(task.options)}, {"jobs", jobs}};
    std::string bytes;
    Json::to_cbor(json, bytes);
    return bytes;
}

ClusterTask taskFrom(const std::string& bytes) {
    const Json json = Json::from_cbor(bytes);
    ClusterTask task;
    task.options = optionsFrom(json.at("options"));
    task.program = json.at("program");
    for (const Json& job : json.at("jobs"))
        takeJob(job, task);
    return task;
}

}  // namespace

fs::path roundFolder(const fs::path& batch, int round) {
    return clusterFolder(batch) / fmt::format("round-{}", round);
}

fs::path batchOfRound(const fs::path& round_folder) {
    return round_folder.parent_path().parent_path();
}

int numberOfRound(const fs::path& round_folder) {
    return round_folder.filename() == "round-1" ? 1 : 2;
}

fs::path toldFolder(const fs::path& batch) {
    return clusterFolder(batch) / "told";
}

void writeTasks(const fs::path& round_folder, const std::vector<ClusterTask>& tasks) {
    std::error_code why;
    fs::create_directories(round_folder, why);
    if (why) throw Error(ErrorCode::OutputUnwritable, round_folder.string(), why.message());
    for (std::size_t number = 0; number < tasks.size(); ++number)
        writeFile(taskFile(round_folder, number), bytesOf(tasks[number]));
}

ClusterTask readTask(const fs::path& round_folder, std::size_t number) {
    const fs::path file = taskFile(round_folder, number);
    try {
        ClusterTask task = taskFrom(readFile(file));
        task.options.out_dir = batchOfRound(round_folder).string();
        return task;
    } catch (const nlohmann::json::exception&) {
        throw Error(ErrorCode::FileUnreadable, file.string(), "is damaged, or no task of this version");
    }
}

std::vector<ClusterTask> readTasks(const fs::path& round_folder) {
    std::vector<ClusterTask> tasks;
    std::error_code ignored;
    while (fs::exists(taskFile(round_folder, tasks.size()), ignored))
        tasks.push_back(readTask(round_folder, tasks.size()));
    return tasks;
}

std::string slurmName(const fs::path& batch) {
    constexpr std::size_t kDigits = 12;
    return "stepmill-" + sha256(fs::weakly_canonical(batch).string()).substr(0, kDigits);
}

void endOldRounds(const fs::path& batch) {
    std::error_code ignored;
    const bool may_run = fs::exists(roundFolder(batch, 1), ignored);
    const std::vector<std::string> jobs =
        may_run ? slurmJobsNamed(slurmName(batch)) : std::vector<std::string>();
    if (!jobs.empty())
        throw Error(ErrorCode::Usage, batch.string(),
                    fmt::format("is being planned by Slurm's jobs {}; wait for them, or end them (scancel "
                                "--name={})",
                                fmt::join(jobs, ", "), slurmName(batch)));
    fs::remove_all(clusterFolder(batch), ignored);
}

}  // namespace stepmill
