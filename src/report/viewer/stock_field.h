#pragma once

#include <vector>

#include "stepmill/setup/setup.h"

namespace stepmill::report {

/// The stock of a setup as heights over a grid of square cells, seen from the spindle: of each cell its
/// highest and its lowest material. Hollows between the two are not told.
struct StockField {
    int columns = 0;
    int rows = 0;        ///< from the stock's lower edge up, along y
    double cell_mm = 0;  ///< the first cell's lower left corner is at the lowest x and y of the stock's box
    /// Row by row, in setup coordinates; top not over bottom: no material.
    std::vector<double> top_mm;
    std::vector<double> bottom_mm;
};

/// The stock as it arrives.
/// \param cells  along the stock's longer side
/// \throws Error(GeometryKernel) where a stock from a file cannot be meshed
StockField arrivingField(const Setup& setup, int cells);

}  // namespace stepmill::report
