#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "stepmill/catalog/read_catalog.h"

namespace stepmill {

/// Puts a JSON schema into words: what it expects of a value, and why a value is not that.
///
/// Knows the words used in schemas/: type, const, enum, number and length limits, pattern, required,
/// properties, additionalProperties, dependencies, items and references to definitions.
class SchemaWords {
  public:
    /// \param schema  outlives this object
    explicit SchemaWords(const nlohmann::json& schema) : root_(schema) {}

    /// The schema of a value reached by field names and list positions from the top; nothing where the schema
    /// does not say.
    const nlohmann::json* find(const std::vector<std::string>& steps) const;

    /// "a number greater than 0", "one of "mm", "inch"".
    std::string expectation(const nlohmann::json& schema) const;

    /// Why `value` itself (not what it contains) breaks the schema; one finding per cause.
    std::vector<CatalogFinding> breaches(const nlohmann::json& schema, const nlohmann::json& value,
                                         const std::string& pointer) const;

    /// Pointers of all fields that the schema does not name, in the value and in all it contains.
    std::vector<std::string> unknownFields(const nlohmann::json& value) const;

  private:
    const nlohmann::json& resolve(const nlohmann::json& schema) const;
    const nlohmann::json* child(const nlohmann::json& schema, const std::string& step) const;
    void collectUnknown(const nlohmann::json& schema, const nlohmann::json& value, const std::string& pointer,
                        std::vector<std::string>& unknown) const;
    std::vector<CatalogFinding> objectBreaches(const nlohmann::json& schema, const nlohmann::json& value,
                                               const std::string& pointer) const;

    const nlohmann::json& root_;
};

}  // namespace stepmill
