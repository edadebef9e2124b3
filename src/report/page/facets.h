#pragma once

#include <array>
#include <vector>

#include <TopoDS_Shape.hxx>

#include "stepmill/part/part.h"

namespace stepmill::report {

/// A triangle of a tessellated face.
struct SolidFacet {
    std::array<Vec3, 3> corners;
    std::size_t face = 0;   ///< its place among the faces in OCCT's order
    bool reversed = false;  ///< its corners run clockwise seen from outside
};

/// The facets of all faces; none of a face without tessellation. Cost: linear in the facets.
std::vector<SolidFacet> facetsOf(const TopoDS_Shape& solid);

}  // namespace stepmill::report
