#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace stepmill {

/// A row of a CSV file with the line it begins on.
struct CsvRow {
    int line = 0;
    std::vector<std::string> cells;
};

/// The rows of a CSV text [RFC 4180]: cells may stand in double quotes and then hold commas, line ends and
/// doubled quotes. Blank lines, blanks round unquoted cells and a byte order mark are left out.
/// \param file  for messages
/// \throws Error(InvalidCatalog) naming file and line where a quote is not closed, or where a zero byte
///         stands
std::vector<CsvRow> readCsv(const std::string& file, std::string_view text);

}  // namespace stepmill
