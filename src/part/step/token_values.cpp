// Numbers, ids and strings of STEP tokens.

#include "part/step/token_values.h"

#include <charconv>
#include <cmath>
#include <system_error>

#include <fmt/format.h>

#include "part/step/kinds.h"
#include "part/step/text.h"

namespace stepmill {

bool isNonFiniteWord(std::string_view word) {
    std::string lower;
    for (const char c : word) {
        if (c != '+' && c != '-') lower += static_cast<char>(c | 0x20);
    }
    for (const std::string_view name : {"nan", "inf", "infinity", "qnan", "snan", "ind", "nanq", "nans"}) {
        if (lower == name) return true;
    }
    return lower.find("#inf") != std::string::npos || lower.find("#ind") != std::string::npos ||
           lower.find("nan") != std::string::npos;
}

std::string unquote(std::string_view quoted) {
    std::string plain;
    for (std::size_t i = 1; i + 1 < quoted.size(); ++i) {
        plain += quoted[i];
        if (quoted[i] == '\'') ++i;
    }
    return plain;
}

std::uint32_t entityId(const StepLexer& lexer, const StepToken& token) {
    std::uint64_t id = 0;
    const char* end = token.text.data() + token.text.size();
    const auto [stop, error] = std::from_chars(token.text.data() + 1, end, id);
    const std::string shown(token.text.substr(0, 40));
    if (stop != end || error == std::errc::invalid_argument)
        lexer.damaged(token.line, "entity number expected, found " + shown);
    if (error == std::errc::result_out_of_range || id > kLargestId)
        lexer.damaged(token.line,
                      fmt::format("entity number up to {} expected, found {}", kLargestId, shown));
    return static_cast<std::uint32_t>(id);
}

double finiteNumber(const StepLexer& lexer, const StepToken& token, std::string_view keyword) {
    std::string_view digits = token.text;
    const std::string shown(token.text.substr(0, 40));
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double number = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool underflow = error == std::errc::result_out_of_range &&
                           token.text.find_first_of("eE") != std::string_view::npos &&
                           token.text.find('-', 1) != std::string_view::npos;
    if (underflow) return 0;
    const bool overflow = error == std::errc::result_out_of_range;
    if (!overflow && (error != std::errc{} || stop != digits.data() + digits.size())) {
        if (isNonFiniteWord(token.text))
            lexer.damaged(token.line, "a finite number expected, found " + shown);
        lexer.damaged(token.line, "a number expected, found " + shown);
    }
    if (!overflow && !std::isfinite(number))
        lexer.damaged(token.line, "a finite number expected, found " + shown);
    if (overflow || (std::abs(number) > kLargestGeometricNumber && isShapeEntity(keyword)))
        lexer.fail(ErrorCode::ImplausibleSize, token.line,
                   "the number " + shown + " in " + std::string(keyword) +
                       " is out of range; values up to 1E12 are taken");
    return number;
}

}  // namespace stepmill
