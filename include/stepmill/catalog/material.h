#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "stepmill/core/file.h"

namespace stepmill {

/// What it takes to cut a material, by Kienzle: a chip h mm thick asks for kc1.1 / h^mc newtons for every mm2
/// of its section.
struct Material {
    std::string name;
    std::vector<std::string> also_called;
    double kc11_n_per_mm2 = 0;  ///< at a chip 1 mm thick
    double mc = 0;              ///< how the force grows as chips get thinner
    std::string source;         ///< where the numbers are from
};

/// The materials a shop cuts.
struct MaterialFile {
    std::string file;  ///< name without folder
    std::vector<Material> materials;

    /// The one of that name, or that is also called so; null where the file does not know it.
    const Material* find(std::string_view name) const;
};

/// Reads a material file (schemas/materials.schema.json).
/// \throws Error(InvalidCatalog) with "file#/json/pointer" as subject: a breach of the schema, a name that
///         two materials have; Error(FileUnreadable).
MaterialFile readMaterials(const std::filesystem::path& path, std::uintmax_t max_bytes = kMaxFileBytes);

/// The same from text already in memory.
MaterialFile materialsFromText(std::string_view text, const std::string& file_name);

/// What a run uses when none are named; compiled in from samples/.
MaterialFile defaultMaterials();

}  // namespace stepmill
