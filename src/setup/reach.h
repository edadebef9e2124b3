#pragma once

#include "setup/facets.h"

namespace stepmill::setup {

/// Share of stock - part that lies above the part along an axis, on a height map of 256 x 256 columns.
///
/// \param part, stock     in part coordinates; no stock facets: the stock is the box
/// \param rotation        rows are x, y and z of the setup
/// \param turned_stock    the stock's box, rotated
/// \param removable_mm3   volume of stock - part
double reachableShare(const Facets& part, const Facets& stock, const Eigen::Matrix3d& rotation,
                      const Box3& turned_stock, double removable_mm3);

}  // namespace stepmill::setup
