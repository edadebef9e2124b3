#pragma once

#include <string>

#include "report/page/element.h"

namespace stepmill::report {

/// Where the viewer's scripts build it; without them, or where the browser has no WebGL, it says so.
Element viewerSection();

/// A page with the viewer.
/// \param main  with a viewerSection()
/// \param data  viewerData()
std::string viewerDocument(const std::string& title, Element main, const std::string& data);

}  // namespace stepmill::report
