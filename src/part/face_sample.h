#pragma once

#include <BRepAdaptor_Surface.hxx>
#include <TopoDS_Face.hxx>

#include "stepmill/part/face_graph.h"

namespace stepmill {

/// Point and outward normal of a face at its parameters; a zero normal at a pole.
/// \param surface  the face's own
FaceSample sampleAt(const TopoDS_Face& face, const BRepAdaptor_Surface& surface, double u, double v);

}  // namespace stepmill
