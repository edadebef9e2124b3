#pragma once

#include "post/reader/control.h"

namespace stepmill::reader {

/// Drills a hole by G81, G82, G83, G73, G85 or G89 [RS274/NGC, 3.5.16], or taps one by G84 after M29.
/// \param cycle  its code
void drill(Control& control, const Block& block, int cycle);

/// Taps from where the tool is by G33.1: down and back up, coupled to the spindle both ways [LinuxCNC 2.9,
/// G33.1].
void tap(Control& control, const Block& block);

}  // namespace stepmill::reader
