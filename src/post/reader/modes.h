#pragma once

#include "post/reader/control.h"

namespace stepmill::reader {

/// Obeys the words of a block that come before its motion, in the order of RS274/NGC [3.8]: feed mode, feed,
/// speed, tool preparation, tool change, spindle, coolant, dwell, plane, units, cutter compensation, distance
/// mode, retract mode, length offset, work offset, path control.
void setModes(Control& control, const Block& block);

}  // namespace stepmill::reader
