#pragma once

#include <string>
#include <vector>

namespace stepmill {

/// A table cell with words.
std::string cell(const std::string& text);
/// One with a number, ranged right.
std::string cell(double value, int decimals);
std::string numberCell(const std::string& text);

/// The head of a table; names that begin with # are of columns of numbers.
std::string headRow(const std::vector<std::string>& names);

}  // namespace stepmill
