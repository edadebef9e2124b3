#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "report/sheets/scene_raster.h"
#include "stepmill/planar/vector.h"

namespace stepmill::report {

/// Edges and outlines of a picture as data of SVG paths, in cells, y down.
struct Strokes {
    std::string edges;     ///< of the stock
    std::string fixtures;  ///< of what holds it
    std::string cuts;      ///< around what is cut here
};

/// Lines that run along cells are straightened to about half a cell.
Strokes strokesOf(const Image& image, double cell_mm);

/// Which cells of an image, row by row: 0 or 1.
using CellMask = std::vector<std::uint8_t>;

template <typename IsIn>
CellMask cellsWhere(const Image& image, IsIn is_in) {
    CellMask mask;
    mask.reserve(image.cells.size());
    for (const SeenCell& cell : image.cells)
        mask.push_back(is_in(cell) ? 1 : 0);
    return mask;
}

/// The area of these cells, as data of an SVG path filled by the even-odd rule.
std::string areaOf(const Image& image, const CellMask& mask);

}  // namespace stepmill::report
