#pragma once

#include <optional>

#include "stepmill/access/access.h"

namespace stepmill::access {

/// The entry of the tool into one component of its free centres: over an open edge if it has one, else by a
/// helix, a ramp, or straight down where the tool may plunge. Nothing where it can do none of these. Which
/// way down is quickest is for the path to say; this one is possible.
std::optional<Entry> findEntry(const FeatureGround& ground, const ToolAssembly& tool,
                               const Region& component);

}  // namespace stepmill::access
