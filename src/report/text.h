#pragma once

#include <string>

namespace stepmill {

/// "4:07" for minutes and seconds, "1:02:09" with hours; rounded to the second, "7.3 s" below a minute.
std::string clockTime(double seconds);

/// Text safe inside HTML and SVG.
std::string escapeHtml(const std::string& text);

}  // namespace stepmill
