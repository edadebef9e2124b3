#pragma once

#include <string>
#include <vector>

#include "stepmill/catalog/filled_field.h"
#include "stepmill/catalog/tool.h"
#include "stepmill/core/squawk_grade.h"

namespace stepmill {

/// Something that whoever looks after a tool library should know: danger where a holder or a cutter may hit
/// something, caution where the tool takes no part in plans or not as it could.
struct ToolSquawk {
    SquawkGrade grade = SquawkGrade::Note;
    std::string tool;  ///< its id; empty: of the whole library
    std::string text;
};

/// What to heed in a library that is valid, by grade and then in its order.
std::vector<ToolSquawk> toolSquawks(const ToolLibrary& library, const FilledFields& filled);

}  // namespace stepmill
