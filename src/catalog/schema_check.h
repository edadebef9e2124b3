#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "stepmill/catalog/json_schema.h"
#include "stepmill/catalog/read_catalog.h"

namespace stepmill {

/// The compiled-in schema, parsed.
nlohmann::json schemaJson(SchemaName name);

/// Breaches of a schema by a value, each cause once, in the document's order.
std::vector<CatalogFinding> checkSchema(const nlohmann::json& schema, const nlohmann::json& value);

}  // namespace stepmill
