#pragma once

#include <string>
#include <vector>

#include "stepmill/catalog/filled_field.h"
#include "stepmill/catalog/tool.h"

namespace stepmill {

/// A picture of a tool in its holder, an SVG file of its own: as seen from the side, tip down, to scale (a
/// millimetre of the tool is `kToolPictureScale` mm of paper), with its diameters and heights written beside
/// it.
std::string toolSvg(const ToolAssembly& tool);
/// So many mm of paper is a mm of tool.
inline constexpr double kToolPictureScale = 1;

/// All that a library says of a tool, a line each.
std::string toolText(const ToolAssembly& tool, const std::vector<FilledField>& filled);

/// A line a tool: number, id, type, diameter, flutes, stick-out, materials.
std::string toolListText(const ToolLibrary& library);

}  // namespace stepmill
