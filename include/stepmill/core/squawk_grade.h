#pragma once

#include <string>

#include "stepmill/core/enum_words.h"

namespace stepmill {

/// How much a squawk matters, the most first: somebody or something may come to harm; a part, time or a tool
/// may be lost; good to know.
enum class SquawkGrade { Danger, Caution, Note };

inline constexpr EnumWord<SquawkGrade> kSquawkGrades[] = {
    {SquawkGrade::Danger, "danger"}, {SquawkGrade::Caution, "caution"}, {SquawkGrade::Note, "note"}};

}  // namespace stepmill
