#pragma once

#include <string_view>

namespace stepmill::report {

/// page.css, how all pages look on the screen and on paper; written by cmake/embed_files.cmake.
extern const std::string_view kPageStyle;

/// sheets.css, what setup sheets add to it.
extern const std::string_view kSheetStyle;

/// part_table.js, which sorts, filters and searches a table of many parts.
extern const std::string_view kPartTableScript;

}  // namespace stepmill::report
