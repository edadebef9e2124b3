#pragma once

#include <string>

#include "report/page/element.h"
#include "stepmill/planar/vector.h"

// Pieces of charts, in the units of their picture, y down.

namespace stepmill::report {

/// Step of 1, 2 or 5 times a power of ten that divides the range into at most that many.
/// \pre range > 0
double niceStep(double range, int most);

Element lineFrom(Tag tag, const Vec2& from, const Vec2& to);
Element textAt(Tag tag, const Vec2& at, const std::string& words);

}  // namespace stepmill::report
