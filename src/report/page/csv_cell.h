#pragma once

#include <string>

namespace stepmill::report {

/// Words as a cell of a CSV file [RFC 4180], on one line. What a spreadsheet would take for a formula begins
/// with a single quote.
std::string csvCell(const std::string& text);

}  // namespace stepmill::report
