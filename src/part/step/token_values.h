#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "part/step/lexer.h"

namespace stepmill {

/// Ids beyond this are cut to 32 bits by geometry readers, where they become those of other entities.
inline constexpr std::uint64_t kLargestId = 2147483647;

/// "nan", "INF", "infinity", "qnan", "ind" in any case: how programs print numbers that are none.
bool isNonFiniteWord(std::string_view word);

/// What stands between the quotes of a string token, doubled quotes as one.
std::string unquote(std::string_view quoted);

/// The id of a reference token.
/// \throws Error(StepDamaged) where it is none up to kLargestId
std::uint32_t entityId(const StepLexer& lexer, const StepToken& token);

/// The value of a number token.
/// \param keyword  of the record it stands in
/// \throws Error(StepDamaged) where it is no finite number, Error(ImplausibleSize) where it is larger than a
/// shape's numbers are
double finiteNumber(const StepLexer& lexer, const StepToken& token, std::string_view keyword);

}  // namespace stepmill
