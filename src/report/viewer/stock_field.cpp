#include "report/viewer/stock_field.h"

#include <algorithm>

#include "report/sheets/scene_raster.h"
#include "stepmill/part/part_shape.h"

namespace stepmill::report {
namespace {

/// Chords of the stock's surface as a share of a cell.
constexpr double kChordShare = 0.25;

/// First surfaces along the tool axis, from above or from below, as heights row by row upwards.
/// \param up  1 from above, -1 from below
std::vector<double> heights(const std::vector<Body>& bodies, const Sight& sight, const StockField& field,
                            double up, double where_empty) {
    const Image image = stockImages(bodies, sight).arriving;
    std::vector<double> found;
    found.reserve(image.cells.size());
    for (int row = 0; row < field.rows; ++row)
        for (int column = 0; column < field.columns; ++column) {
            // From above y runs up the picture, from below down it.
            const SeenCell& cell = image.at(column, up > 0 ? field.rows - 1 - row : row);
            found.push_back(cell.what == Shown::Stock ? up * cell.depth_mm : where_empty);
        }
    return found;
}

}  // namespace

StockField arrivingField(const Setup& setup, int cells) {
    // Whole cells, so that pictures from both sides have the same ones.
    Box3 box = setup.stock_bbox_mm;
    StockField field;
    field.cell_mm = std::max(1e-3, box.sizes().head<2>().maxCoeff() / cells);
    for (int axis : {0, 1})
        box.max()[axis] =
            box.min()[axis] + field.cell_mm * std::ceil(box.sizes()[axis] / field.cell_mm - 1e-6);
    field.columns = static_cast<int>(std::lround(box.sizes().x() / field.cell_mm));
    field.rows = static_cast<int>(std::lround(box.sizes().y() / field.cell_mm));
    guardOcct(ErrorCode::GeometryKernel, "stock of " + setup.id, [&] {
        const std::vector<Body> bodies = arrivingStock(setup, kChordShare * field.cell_mm);
        const Sight above(Vec3::UnitZ(), Vec3::UnitX(), box, cells);
        const Sight below(-Vec3::UnitZ(), Vec3::UnitX(), box, cells);
        field.top_mm = heights(bodies, above, field, 1, box.min().z());
        field.bottom_mm = heights(bodies, below, field, -1, box.max().z());
    });
    return field;
}

}  // namespace stepmill::report
