#pragma once

#include <string_view>

namespace stepmill::report {

/// page.css, how all pages look on the screen and on paper; written by cmake/embed_files.cmake.
extern const std::string_view kPageStyle;

}  // namespace stepmill::report
