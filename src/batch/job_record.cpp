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
    std::error_code why;
    fs::create_directories(file.parent_path(), why);
    if (why) throw Error(ErrorCode::OutputUnwritable, file.parent_path().string(), why.message());
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

void removeRecord(const fs::path& batch, const BatchJob& job) {
    std::error_code ignored;
    fs::remove(recordFile(batch, job.key), ignored);
}

}  // namespace stepmill
