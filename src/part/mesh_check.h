#pragma once

#include <string>

#include <TopoDS_Shape.hxx>

#include "stepmill/part/part_shape.h"

namespace stepmill {

/// Volume of a solid from triangles, by the integrals of x dA_x, y dA_y and z dA_z over its faces. For faces
/// that close and all look outwards the three are one number, to rounding, however coarse the triangles; a
/// face that is turned over, missing or doubled sets them apart.
struct MeshVolume {
    double mean_mm3 = 0;    ///< of the three
    double spread_mm3 = 0;  ///< between the smallest and the largest
    int bare_faces = 0;     ///< faces that could not be meshed
};

/// Leaves no triangles on the shape.
/// \pre the shape has a size
MeshVolume meshVolume(const TopoDS_Shape& solid);

/// Refuses a solid whose triangles contradict it: faces turned over or without triangles, an edge that
/// crosses itself, a volume far from the exact one.
/// \param exact_mm3  volume of the solid by its faces
/// \throws Error(InvalidSolid)
void requireMesh(const TopoDS_Shape& solid, double exact_mm3, const std::string& subject);

}  // namespace stepmill
