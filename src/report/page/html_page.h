#pragma once

#include <string>

namespace stepmill {

/// A page up to its first content, with a Content-Security-Policy that allows its own style and nothing
/// else: no script, no picture from elsewhere, no style attribute.
std::string pageHead(const std::string& title, const std::string& style);

/// What closes such a page.
std::string pageEnd();

}  // namespace stepmill
