#pragma once

#include <string>
#include <string_view>

#include "stepmill/planar/region.h"

namespace stepmill {

/// Regions as text one can read, edit and keep beside a test. One loop per line:
///
///     loop 0 0  line 10 0  arc 12 2 centre 10 2 ccw  line 0 2  close
///     circle 5 1 radius 0.5 cw
///
/// `#` starts a comment. Coordinates in mm.
std::string toText(const Region& region);
/// \throws Error(InvalidRegion) naming `subject`, the line and what was expected.
Region regionFromText(std::string_view text, const std::string& subject);

}  // namespace stepmill
