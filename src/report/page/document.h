#pragma once

#include <string>
#include <string_view>
#include <vector>

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

/// What makes a page more than a page to read.
struct PageScripts {
    std::vector<std::string_view> scripts;  ///< ours, or a library's; they run in this order
    std::string_view style;                 ///< of what they build, beside page.css
};

/// The same with scripts, each of which the policy allows by hash. They take what they show from `data` and
/// make text and elements of it, never markup.
/// \param data  dataElement() of what the scripts show
std::string scriptedDocument(const std::string& title, Element main, Element data, const PageScripts& with);

}  // namespace stepmill::report
