#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stepmill {

/// Commands that write into a job folder.
enum class JobWriter { Plan, Post, Inspect, Curves };

/// A file of a job, as it was when it was written.
struct ManifestFile {
    std::string name;
    JobWriter by = JobWriter::Plan;
    std::string dialect;  ///< of a program; empty for other files
    std::uint64_t size_bytes = 0;
    std::string sha256;
};

/// What was written into a job folder: manifest.json [docs/jobs.md, schemas/manifest.schema.json]. It is the
/// folder's seal: a folder that has one holds one whole job.
struct Manifest {
    std::string part_file;
    std::string part_sha256;
    std::string plan_sha256;          ///< of the plan.json that the programs belong to; may be empty
    std::vector<ManifestFile> files;  ///< by name; all but the manifest itself
    std::vector<std::string> solids;  ///< folders below this one that are jobs of their own
};

inline constexpr const char* kManifestName = "manifest.json";

/// The file's text: same manifest, same bytes.
/// \throws Error(Internal) if it breaks its schema.
std::string manifestJson(const Manifest& manifest);

/// \throws Error(InvalidCatalog) with "manifest.json#/json/pointer" as subject
Manifest manifestFromText(std::string_view text);

/// The folder's manifest; nothing where there is none.
/// \throws what manifestFromText does, with the folder in the subject; Error(FileUnreadable)
std::optional<Manifest> readManifest(const std::filesystem::path& folder);

/// The file of that name; null for none.
const ManifestFile* findFile(const Manifest& manifest, const std::string& name);

/// True for names of NC programs ("S1.ngc", "O0001.NC"), whoever wrote them: what a machine may load.
bool isProgramName(const std::string& name);

}  // namespace stepmill
