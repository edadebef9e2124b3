#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

namespace stepmill {

/// Names of the schemas compiled in from schemas/.
enum class SchemaName {
    Tools,
    Machine,
    Plan,
    Inspect,
    Rank,
    Fixtures,
    Holes,
    Verify,
    Manifest,
    Quote,
    Job,
    Materials,
    CuttingData,
    Replan
};
std::string_view schemaText(SchemaName name);
/// The version of the files that it describes: their "format".
int schemaFormat(SchemaName name);

/// Breaches of a schema by a JSON text, each "#/json/pointer: what was expected". A text that is not JSON
/// gives one line with its line and column. Empty when all is well.
std::vector<std::string> schemaErrors(SchemaName name, std::string_view json_text);

/// The text of a JSON file of ours (plan.json, manifest.json, ...): the heading, which is the file's format
/// and the program's version, then the content in its order, laid out for people: what fits on a line stands
/// on one. A line end at the end, and U+FFFD for bytes that are no UTF-8, since names come from strangers'
/// files. The same content gives the same bytes.
/// \param content  an object without "format" and "stepmill"
/// \throws Error(Internal) naming the file if the text breaks the schema: nothing untrue leaves
std::string finishJson(SchemaName name, nlohmann::ordered_json content);

}  // namespace stepmill
