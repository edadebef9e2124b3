#pragma once

#include "post/reader/control.h"

namespace stepmill::reader {

/// Drills a hole by G81, G82 or G83 [RS274/NGC, 3.5.16]. \param cycle  its code
void drill(Control& control, const Block& block, int cycle);

}  // namespace stepmill::reader
