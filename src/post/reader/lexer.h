#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "post/dialect.h"
#include "post/reader/where.h"

namespace stepmill::reader {

/// A letter and its number.
struct Word {
    char letter = 0;  ///< upper case
    double value = 0;
    bool has_point = false;
};

/// A line in parts.
struct Line {
    std::vector<Word> words;
    std::vector<std::string> comments;
    bool percent = false;  ///< a % and nothing else
};

/// Splits a line as RS274/NGC does: blanks mean nothing, neither does case; comments stand in brackets or
/// after a semicolon; a number is a sign, digits and a point, nothing else. Refuses parameters, expressions,
/// block delete, and comments that a controller acts on.
Line lex(std::string_view text, const DialectRules& rules, const Where& where);

}  // namespace stepmill::reader
