#include <nlohmann/json.hpp>

#include "catalog/schema_check.h"
#include "stepmill/catalog/job_details.h"
#include "stepmill/catalog/json_text.h"

namespace stepmill {
namespace {

/// \pre keeps the schema
JobDetails detailsIn(const nlohmann::json& from) {
    const auto words = [&](const char* field) { return from.value(field, std::string()); };
    JobDetails job;
    job.part = words("part");
    job.part_number = words("part_number");
    job.revision = words("revision");
    job.description = words("description");
    job.document = words("document");
    job.order = words("order");
    job.customer = words("customer");
    job.programmer = words("programmer");
    job.date = words("date");
    job.machine = words("machine");
    job.controller = words("controller");
    job.material = words("material");
    job.quantity = from.value("quantity", 0);
    job.notes = from.value("notes", std::vector<std::string>());
    return job;
}

}  // namespace

JobDetails jobDetailsFromText(std::string_view text, const std::string& file_name) {
    const ParsedJson parsed = checkedJson(text, schemaJson(SchemaName::Job));
    throwFirstError(parsed.findings, file_name);
    return detailsIn(parsed.value);
}

JobDetails readJobDetails(const std::filesystem::path& path, std::uintmax_t max_bytes) {
    return jobDetailsFromText(readFile(path, max_bytes), path.filename().string());
}

}  // namespace stepmill
