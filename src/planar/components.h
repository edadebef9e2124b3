#pragma once

#include <optional>
#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill::planar {

/// components(), or nothing where a hole lies outside all outer loops.
std::optional<std::vector<Region>> componentsIfNested(const Region& region);

}  // namespace stepmill::planar
