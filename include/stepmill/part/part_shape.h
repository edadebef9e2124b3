#pragma once

// Only for the modules that speak OCCT: part, setup, layers, and report's pictures.

#include <functional>
#include <string>

#include <TopoDS_Shape.hxx>

#include "stepmill/core/error.h"
#include "stepmill/part/part.h"

namespace stepmill {

/// One closed solid with outward faces, in mm and part coordinates. It is never changed after it was made, so
/// threads may read it side by side; who meshes it copies it first.
struct PartShape {
    TopoDS_Shape solid;
};

/// Wraps a solid made elsewhere (tests, sample parts) as a Part with its box, volume and faces.
/// \param solid  in mm; a compound that holds one solid and nothing else will do
/// \throws Error(InvalidSolid) unless the shape is one valid closed solid.
/// \note  O(faces); integrates volume and areas.
Part makePart(const TopoDS_Shape& solid, const std::string& name);

/// Calls `work` and turns Standard_Failure into Error(code, subject).
void guardOcct(ErrorCode code, const std::string& subject, const std::function<void()>& work);

}  // namespace stepmill
