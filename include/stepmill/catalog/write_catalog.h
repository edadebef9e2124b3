#pragma once

#include <string>

#include "stepmill/catalog/filled_field.h"
#include "stepmill/catalog/tool.h"

namespace stepmill {

/// The text of a tool library (schemas/tools.schema.json), lengths in the library's unit, laid out for
/// people. What readToolLibrary() makes of it equals `library` but for rounding to nine digits; a field that
/// says what the reader takes anyway is left out. A range of stick-outs is written as one, heights of the
/// holder are those of the longest.
/// \param description  a note on the library; empty: none
/// \param filled  which fields no one measured
std::string toolLibraryJson(const ToolLibrary& library, const std::string& description,
                            const FilledFields& filled = {});

}  // namespace stepmill
