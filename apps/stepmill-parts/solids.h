#pragma once

// Short words for the solids that sample parts are cut from; every length in mm.

#include <vector>

#include <TopoDS_Shape.hxx>

namespace stepmill {

struct Corner {
    double x_mm = 0;
    double y_mm = 0;
    double radius_mm = 0;  ///< 0: sharp
};

/// Corners of a rectangle, all with the same radius.
std::vector<Corner> rectangle(double x0, double y0, double x1, double y1, double radius = 0);

/// Upright prism over a counter-clockwise outline with rounded corners, from z0 to z1.
TopoDS_Shape prism(const std::vector<Corner>& outline, double z0, double z1);

TopoDS_Shape box(double x0, double y0, double z0, double x1, double y1, double z1);

/// Upright cylinder.
TopoDS_Shape cylinder(double x, double y, double diameter, double z0, double z1);

/// Turned so that +z becomes +x, +x becomes +y and +y becomes +z, then moved by (x, y, z).
TopoDS_Shape facingX(const TopoDS_Shape& shape, double x, double y, double z);

/// Turned so that +z becomes +y, +x becomes -x and +y becomes +z, then moved by (x, y, z).
TopoDS_Shape facingY(const TopoDS_Shape& shape, double x, double y, double z);

/// `base` plus `added` minus `removed` as one solid, faces of one surface joined.
/// \throws Error(GeometryKernel) when the result is not one valid solid
TopoDS_Shape assemble(const TopoDS_Shape& base, const std::vector<TopoDS_Shape>& added,
                      const std::vector<TopoDS_Shape>& removed);

}  // namespace stepmill
