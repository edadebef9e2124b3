#pragma once

#include <string>
#include <string_view>

namespace stepmill {

/// Text of strangers made fit for a terminal or a page: bytes that are no UTF-8, control characters but line
/// end and tab, and marks that turn the direction of writing are each U+FFFD. What is fit stays as it is.
std::string plainText(std::string_view text);

/// The same for a name inside a line: line ends and tabs are spaces.
std::string plainLine(std::string_view text);

/// Text without the three bytes that some editors write before a UTF-8 text; readers stumble over them.
std::string_view withoutByteOrderMark(std::string_view text);

/// Text without blanks, tabs and line ends before and after it.
std::string_view trimmed(std::string_view text);

}  // namespace stepmill
