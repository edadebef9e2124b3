#pragma once

#include <string>

#include "report/page/element.h"

namespace stepmill::report {

/// A whole page in one file: pictures stand in it, nothing is loaded. Its Content-Security-Policy allows its
/// own style sheet (page.css) by hash and nothing else: no script, no picture from elsewhere, no style
/// attribute.
/// \param title  of the window; any text
/// \param main   a <main> with all that the page shows
std::string htmlDocument(const std::string& title, Element main);

/// The same with a style sheet of its own in place of page.css.
std::string printedDocument(const std::string& title, Element main, std::string_view style);

/// The same with a table of many parts (part_table.js), which the policy allows by hash too.
/// \param data  dataElement() of what the script shows
std::string partTableDocument(const std::string& title, Element main, Element data);

}  // namespace stepmill::report
