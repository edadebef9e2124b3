#pragma once

#include "post/reader/control.h"

namespace stepmill::reader {

/// Where the axis words of a block lead.
Place target(const Control& control, const Block& block);

/// G28 and G30: a rapid to the place the words name, from there to the axes' own. Without words all axes go.
void goHome(Control& control, const Block& block);

/// Makes the block's motion, which then stays in force.
/// \param motion  its code
void move(Control& control, const Block& block, int motion);

}  // namespace stepmill::reader
