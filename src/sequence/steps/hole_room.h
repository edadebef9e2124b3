#pragma once

#include <optional>
#include <string>

#include "stepmill/catalog/tool.h"
#include "stepmill/feature/feature.h"

namespace stepmill {

/// Does a cylinder around the hole's axis meet what stands over its bottom?
bool meetsObstacle(const Feature& hole, const Vec2& axis, double bottom_z_mm, double radius_mm);

/// Width of the first part of the tool, `cutter` before shank and holder, that meets what stands over the top
/// of a hole with its tip at that height; nothing where none does. In the hole there is room.
std::optional<double> widthThatMeets(const Feature& hole, const ToolAssembly& tool,
                                     const HolderCylinder& cutter, double tip_z_mm);

/// In words, what a tool with flutes meets so beside the hole; empty where it meets nothing.
std::string troubleBeside(const Feature& hole, const ToolAssembly& tool, double tip_z_mm);

}  // namespace stepmill
