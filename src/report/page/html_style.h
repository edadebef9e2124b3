#pragma once

namespace stepmill {

/// How report.html looks, on the screen and on paper.
extern const char* const kReportStyle;

}  // namespace stepmill
