#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "catalog/embedded.h"
#include "catalog/schema_check.h"
#include "stepmill/catalog/material.h"
#include "stepmill/core/error.h"

namespace stepmill {
namespace {

using nlohmann::json;

constexpr const char* kDefaultMaterialsName = "materials.json";

/// Reads a document that keeps the schema.
class MaterialReader {
  public:
    MaterialReader(const json& from, const std::string& file_name) : from_(from), file_name_(file_name) {}

    MaterialFile read() {
        MaterialFile file{file_name_, {}};
        for (std::size_t i = 0; i < from_["materials"].size(); ++i)
            file.materials.push_back(material(from_["materials"][i], fmt::format("#/materials/{}", i)));
        return file;
    }

  private:
    Material material(const json& from, const std::string& pointer) {
        Material material;
        material.name = uniqueName(from["name"], pointer + "/name");
        const json others = from.value("also_called", json::array());
        for (std::size_t i = 0; i < others.size(); ++i)
            material.also_called.push_back(
                uniqueName(others[i], fmt::format("{}/also_called/{}", pointer, i)));
        material.kc11_n_per_mm2 = from["kc11_n_per_mm2"];
        material.mc = from["mc"];
        material.source = from["source"];
        return material;
    }

    /// A name that means two materials would mean neither.
    std::string uniqueName(const std::string& name, const std::string& pointer) {
        const auto [first, is_new] = seen_.emplace(name, pointer);
        if (!is_new)
            throw Error(ErrorCode::InvalidCatalog, file_name_ + pointer,
                        fmt::format("expected a name that no other material has, found \"{}\" as in {}", name,
                                    first->second));
        return name;
    }

    const json& from_;
    const std::string& file_name_;
    std::map<std::string, std::string> seen_;  ///< names with their pointers
};

}  // namespace

const Material* MaterialFile::find(std::string_view name) const {
    const auto is_meant = [&](const Material& material) {
        return material.name == name || std::find(material.also_called.begin(), material.also_called.end(),
                                                  name) != material.also_called.end();
    };
    const auto found = std::find_if(materials.begin(), materials.end(), is_meant);
    return found == materials.end() ? nullptr : &*found;
}

MaterialFile materialsFromText(std::string_view text, const std::string& file_name) {
    const ParsedJson parsed = checkedJson(text, schemaJson(SchemaName::Materials));
    throwFirstError(parsed.findings, file_name);
    return MaterialReader(parsed.value, file_name).read();
}

MaterialFile readMaterials(const std::filesystem::path& path, std::uintmax_t max_bytes) {
    return materialsFromText(readFile(path, max_bytes), path.filename().string());
}

MaterialFile defaultMaterials() {
    return materialsFromText(embedded::kDefaultMaterials, kDefaultMaterialsName);
}

}  // namespace stepmill
