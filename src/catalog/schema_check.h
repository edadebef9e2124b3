#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "stepmill/catalog/json_schema.h"
#include "stepmill/catalog/json_text.h"
#include "stepmill/catalog/read_catalog.h"

namespace stepmill {

/// The compiled-in schema, parsed.
nlohmann::json schemaJson(SchemaName name);

/// Breaches of a schema by a value, each cause once, in the document's order.
std::vector<CatalogFinding> checkSchema(const nlohmann::json& schema, const nlohmann::json& value);

/// A file's value with all that was found in it; the value may be used when no finding is an error.
ParsedJson checkedJson(std::string_view text, const nlohmann::json& schema);

/// \throws Error(InvalidCatalog) for the first finding that is an error, "file#/json/pointer" as its subject.
void throwFirstError(const std::vector<CatalogFinding>& findings, const std::string& file_name);

}  // namespace stepmill
