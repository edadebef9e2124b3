#pragma once

#include <optional>
#include <string>

#include "stepmill/access/access.h"

namespace stepmill::access {

/// What rules a tool out whatever the areas are: its type, no cutting data, flutes shorter than a pass.
std::optional<Exclusion> unsuitable(const FeatureGround& ground, const ToolAssembly& tool,
                                    const std::string& material);

/// The drill's own rules, its length and holder at the hole's centre included.
/// \pre tool.isDrill()
std::optional<Exclusion> unsuitableDrill(const FeatureGround& ground, const ToolAssembly& tool,
                                         const std::string& material);

}  // namespace stepmill::access
