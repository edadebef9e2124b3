#pragma once

#include <map>
#include <vector>

#include <gp_Ax2.hxx>
#include <TopoDS_Shape.hxx>

#include "stepmill/planar/region.h"

namespace stepmill {

/// By tint: rectangles that together fill what is visible, as four corners each.
using Shading = std::map<int, std::vector<std::vector<Vec2>>>;

/// What is visible of each face of a solid, on a raster fine enough for a drawing.
/// \param solid   with facets
/// \param plane   of the view, x to the right, towards the viewer
/// \param tints   by face in the order of TopExp_Explorer; negative: not filled, but hides others
Shading shade(const TopoDS_Shape& solid, const gp_Ax2& plane, const std::vector<int>& tints);

}  // namespace stepmill
