#include "stepmill/batch/job_record.h"

#include <nlohmann/json.hpp>

#include "stepmill/batch/part_figures.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/job/manifest.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

fs::path recordFile(const fs::path& batch, const JobKey& key) {
    return batch / "records" / (key.text() + ".json");
}

fs::path taskRecordFile(const fs::path& batch, const JobKey& key) {
    return batch / "records" / (key.text() + ".task.json");
}

void makeFolderOf(const fs::path& file) {
    std::error_code why;
    fs::create_directories(file.parent_path(), why);
    if (why) throw Error(ErrorCode::OutputUnwritable, file.parent_path().string(), why.message());
}

/// Messages repeat names of files, and these are any bytes.
std::string lineOf(const Json& json) {
    return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json jsonOf(const TaskRecord& record) {
    const BatchJob& job = record.job;
    return {{"outcome", toString(job.outcome)},
            {"exit_code", job.exit_code},
            {"message", job.message},
            {"tries", job.tries},
            {"started", job.started},
            {"seconds", job.seconds},
            {"node", record.node}};
}

TaskRecord taskRecordFrom(const Json& json, BatchJob job) {
    job.outcome = outcomeFrom(json.at("outcome").get<std::string>()).value_or(Outcome::Waiting);
    job.exit_code = json.at("exit_code");
    job.message = json.at("message");
    job.tries = json.at("tries");
    job.started = json.at("started");
    job.seconds = json.at("seconds");
    return {std::move(job), json.at("node")};
}

/// The manifests name every file of the job, and of its solids, with its SHA-256.
std::string sealOf(const fs::path& batch, const BatchJob& job) {
    const fs::path folder = jobFolder(batch, job);
    const std::string text = readFile(folder / kManifestName);
    std::string all = text;
    for (const std::string& solid : manifestFromText(text).solids)
        all += readFile(folder / solid / kManifestName);
    return sha256(all);
}

}  // namespace

fs::path jobFolder(const fs::path& batch, const BatchJob& job) {
    return batch / "jobs" / job.folder;
}

void writeRecord(const fs::path& batch, const BatchJob& job, const JobRecord& record) {
    const fs::path file = recordFile(batch, job.key);
    makeFolderOf(file);
    const Json json{{"manifest_sha256", sealOf(batch, job)},
                    {"exit_code", record.exit_code},
                    {"figures", record.figures}};
    writeFile(file, json.dump() + "\n");
}

std::optional<JobRecord> readRecord(const fs::path& batch, const BatchJob& job) {
    const fs::path file = recordFile(batch, job.key);
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return std::nullopt;
    try {
        const Json json = Json::parse(readFile(file));
        if (json.at("manifest_sha256") != sealOf(batch, job)) return std::nullopt;
        JobRecord record{json.at("exit_code"), json.at("figures")};
        figuresFromJson(record.figures);  // what was cut off or edited is no record
        return record;
    } catch (const Error&) {
        return std::nullopt;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    }
}

void writeTaskRecord(const fs::path& batch, const TaskRecord& record) {
    const fs::path file = taskRecordFile(batch, record.job.key);
    makeFolderOf(file);
    writeFile(file, lineOf(jsonOf(record)));
}

std::optional<TaskRecord> readTaskRecord(const fs::path& batch, const BatchJob& job) {
    const fs::path file = taskRecordFile(batch, job.key);
    std::error_code ignored;
    if (!fs::exists(file, ignored)) return std::nullopt;
    try {
        return taskRecordFrom(Json::parse(readFile(file)), job);
    } catch (const Error&) {
        return std::nullopt;
    } catch (const nlohmann::json::exception&) {
        return std::nullopt;
    }
}

void removeRecord(const fs::path& batch, const BatchJob& job) {
    std::error_code ignored;
    fs::remove(recordFile(batch, job.key), ignored);
    fs::remove(taskRecordFile(batch, job.key), ignored);
}

}  // namespace stepmill
