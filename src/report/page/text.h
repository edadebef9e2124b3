#pragma once

#include <string>

namespace stepmill {

struct ToolSequence;

/// "4:07" for minutes and seconds, "1:02:09" with hours; rounded to the second, "7.3 s" below a minute.
std::string clockTime(double seconds);

/// Text safe inside HTML and SVG, in an attribute too, and fit to be read (plainText).
std::string escapeHtml(const std::string& text);

/// The tools of a feature in order: "EM25 (+ EM10) > EM4", surrogates in brackets after the tool they help;
/// "none fits" without any.
std::string toolWords(const ToolSequence& sequence);

}  // namespace stepmill
