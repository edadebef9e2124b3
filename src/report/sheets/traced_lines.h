#pragma once

#include <functional>
#include <string>
#include <vector>

#include "report/sheets/scene_raster.h"
#include "stepmill/planar/vector.h"

namespace stepmill::report {

/// How the line between two neighbouring cells is drawn.
enum class Stroke : std::uint8_t {
    None,
    Edge,     ///< of the stock
    Fixture,  ///< of what holds it
    Cut       ///< around what is cut here
};

/// Edges and outlines of a picture as data of SVG paths, in cells, y down. Lines that run along cells are
/// straightened to about half a cell.
std::string strokesOf(const Image& image, double cell_mm, Stroke stroke);

/// The area of cells of which `is_in` holds, as data of an SVG path filled by the even-odd rule.
std::string areaOf(const Image& image, const std::function<bool(const SeenCell&)>& is_in);

}  // namespace stepmill::report
