#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stepmill {

/// Names of the schemas compiled in from schemas/.
enum class SchemaName { Tools, Machine, Plan, Inspect, Rank, Fixtures, Verify, Manifest };
std::string_view schemaText(SchemaName name);

/// Breaches of a schema by a JSON text, each "#/json/pointer: what was expected". A text that is not JSON
/// gives one line with its line and column. Empty when all is well.
std::vector<std::string> schemaErrors(SchemaName name, std::string_view json_text);

}  // namespace stepmill
