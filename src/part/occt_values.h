#pragma once

#include <gp_Pnt.hxx>
#include <TopoDS_Shape.hxx>

#include "stepmill/part/part.h"

namespace stepmill {

inline Vec3 toVec3(const gp_Pnt& p) {
    return {p.X(), p.Y(), p.Z()};
}

/// The shape as it is drawn once, wherever it is placed and however it is turned: uses of one shape are
/// equal.
inline TopoDS_Shape unplaced(const TopoDS_Shape& shape) {
    return shape.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
}

}  // namespace stepmill
