#pragma once

#include <optional>

#include "stepmill/access/access.h"

namespace stepmill::access {

/// How the tool gets into one component of its free centres: over an open edge, else by a helix, a ramp or
/// straight down; nothing when it can do none of these.
std::optional<Entry> findEntry(const FeatureGround& ground, const ToolAssembly& tool,
                               const Region& component);

}  // namespace stepmill::access
