#pragma once

#include <vector>

#include <nlohmann/json.hpp>

#include "stepmill/catalog/read_catalog.h"

namespace stepmill {

/// What a schema cannot say of a tool library, checked in the file's own unit so that the messages show the
/// file's own numbers; limits in millimetres are converted.
/// \pre `library` keeps schemas/tools.schema.json
std::vector<CatalogFinding> checkLibraryRules(const nlohmann::json& library);

}  // namespace stepmill
