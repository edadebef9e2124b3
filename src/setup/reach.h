#pragma once

#include <array>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "stepmill/setup/setup.h"

namespace stepmill::setup {

/// Facets of a solid, good enough to measure reach and containment on.
using Facets = std::vector<std::array<Vec3, 3>>;

/// Facets with a sagitta of a thousandth of the solid's size. The solid itself is not touched.
Facets coarseFacets(const TopoDS_Shape& solid);

/// Share of stock - part that lies above the part along an axis, on a height map of 256 x 256 columns.
///
/// \param part, stock     in part coordinates; no stock facets: the stock is the box
/// \param rotation        rows are x, y and z of the setup
/// \param turned_stock    the stock's box, rotated
/// \param removable_mm3   volume of stock - part
double reachableShare(const Facets& part, const Facets& stock, const Eigen::Matrix3d& rotation,
                      const Box3& turned_stock, double removable_mm3);

}  // namespace stepmill::setup
