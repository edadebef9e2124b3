#pragma once

#include <optional>

#include "post/reader/control.h"

namespace stepmill::reader {

/// The motion code that a block's words are for: its own, or the one in force; nothing without motion.
std::optional<int> motionOf(const Control& control, const Block& block);

/// Refuses words that nothing in the block uses, and codes that do not go together.
/// \param motion  motionOf() the block
void checkBlock(const Control& control, const Block& block, std::optional<int> motion);

}  // namespace stepmill::reader
