#include "stepmill/job/manifest.h"

#include <algorithm>
#include <cctype>

#include <nlohmann/json.hpp>

#include "stepmill/catalog/json_schema.h"
#include "stepmill/core/enum_words.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

constexpr EnumWord<JobWriter> kWriters[] = {{JobWriter::Plan, "plan"},
                                            {JobWriter::Post, "post"},
                                            {JobWriter::Inspect, "inspect"},
                                            {JobWriter::Curves, "curves"}};

/// Of a word that the schema let through.
JobWriter writerFrom(const std::string& word) {
    const std::optional<JobWriter> writer = valueOf(kWriters, word);
    STEPMILL_CHECK(writer.has_value(), "the manifest's schema knows a writer that the program does not");
    return *writer;
}

Json fileJson(const ManifestFile& file) {
    Json json{{"name", file.name}, {"by", wordOf(kWriters, file.by)}};
    if (!file.dialect.empty()) json["dialect"] = file.dialect;
    json["size_bytes"] = file.size_bytes;
    json["sha256"] = file.sha256;
    return json;
}

ManifestFile fileFrom(const Json& json) {
    return {json.at("name").get<std::string>(), writerFrom(json.at("by").get<std::string>()),
            json.value("dialect", ""), json.at("size_bytes").get<std::uint64_t>(),
            json.at("sha256").get<std::string>()};
}

bool comesBefore(const ManifestFile& one, const ManifestFile& other) {
    return one.name < other.name;
}

}  // namespace

std::string manifestJson(const Manifest& manifest) {
    std::vector<ManifestFile> sorted = manifest.files;
    std::sort(sorted.begin(), sorted.end(), comesBefore);
    Json files = Json::array();
    for (const ManifestFile& file : sorted)
        files.push_back(fileJson(file));
    Json content{{"part", {{"file", manifest.part_file}, {"sha256", manifest.part_sha256}}}};
    if (!manifest.plan_sha256.empty()) content["plan_sha256"] = manifest.plan_sha256;
    content["files"] = files;
    if (!manifest.solids.empty()) content["solids"] = manifest.solids;
    return finishJson(SchemaName::Manifest, std::move(content));
}

Manifest manifestFromText(std::string_view text) {
    const std::vector<std::string> errors = schemaErrors(SchemaName::Manifest, text);
    if (!errors.empty()) throw Error(ErrorCode::InvalidCatalog, kManifestName, errors.front());
    const Json json = Json::parse(text);
    Manifest manifest;
    manifest.part_file = json.at("part").at("file").get<std::string>();
    manifest.part_sha256 = json.at("part").at("sha256").get<std::string>();
    manifest.plan_sha256 = json.value("plan_sha256", "");
    for (const Json& file : json.at("files"))
        manifest.files.push_back(fileFrom(file));
    std::sort(manifest.files.begin(), manifest.files.end(), comesBefore);
    if (json.contains("solids")) manifest.solids = json.at("solids").get<std::vector<std::string>>();
    return manifest;
}

std::optional<Manifest> readManifest(const std::filesystem::path& folder) {
    const std::filesystem::path file = folder / kManifestName;
    std::error_code ignored;
    if (!std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) return std::nullopt;
    try {
        return manifestFromText(readFile(file));
    } catch (const Error& error) {
        if (error.code() != ErrorCode::InvalidCatalog) throw;
        throw Error(ErrorCode::InvalidCatalog, folder.string(), error.what());
    }
}

const ManifestFile* findFile(const Manifest& manifest, const std::string& name) {
    for (const ManifestFile& file : manifest.files)
        if (file.name == name) return &file;
    return nullptr;
}

bool isProgramName(const std::string& name) {
    static constexpr std::array kEndings = {".ngc", ".nc",  ".gcode", ".cnc", ".tap", ".gc",  ".gco", ".mpf",
                                            ".spf", ".eia", ".min",   ".ptp", ".fnc", ".dnc", ".nci", ".iso"};
    std::string ending = std::filesystem::path(name).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}

}  // namespace stepmill
