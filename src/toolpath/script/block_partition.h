#pragma once

#include <vector>

#include "toolpath/script/depth_progress.h"

namespace stepmill::toolpath {

/// Cuts a finished depth into blocks such that no block needs ground that another one clears. They come in
/// the order of their first spots; nothing where all spots belong together. Two spots belong together where
/// one counts on ground that the other clears, or has to wait for it.
std::vector<DepthBlock> blocksApart(const DepthTask& task, const DepthProgress& cut);

}  // namespace stepmill::toolpath
