#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "stepmill/catalog/read_catalog.h"

namespace stepmill {

/// A JSON text and what is wrong with it before any schema is looked at.
// NOLINTNEXTLINE(bugprone-exception-escape): json's own destructor is noexcept, though it allocates.
struct ParsedJson {
    nlohmann::json value;                  ///< discarded when the text is not JSON
    std::vector<CatalogFinding> findings;  ///< one syntax error with line and column, or fields given twice
};
ParsedJson parseJson(std::string_view text);

/// `pointer` with one more step, "~" and "/" in the name escaped [RFC 6901].
std::string childPointer(const std::string& pointer, const std::string& name);
std::string childPointer(const std::string& pointer, std::size_t index);

/// The value as in the file, cut to a length that fits a message.
std::string quoted(const nlohmann::json& value);

}  // namespace stepmill
