#pragma once

#include "report/page/faceted_part.h"
#include "report/viewer/packed_bytes.h"

namespace stepmill::report {

/// The part's facets for the viewer, in part coordinates. Corners are not shared between faces, so that edges
/// of the part stay sharp where facets of one face are smooth.
struct PartMesh {
    std::size_t corners = 0;
    std::size_t triangles = 0;
    Box3 box_mm;  ///< of the corners
    /// X, y, z of each corner in two bytes, 0 to 65535 from the box's low to its high end.
    PackedBytes places;
    PackedBytes sides;  ///< three corners a triangle, each told from the one before, seen from outside
                        ///< counter-clockwise
};

/// \throws Error(GeometryKernel)
PartMesh partMesh(const FacetedPart& faceted);

}  // namespace stepmill::report
