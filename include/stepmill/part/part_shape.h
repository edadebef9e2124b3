#pragma once

// Only for the modules that speak OCCT: part, setup, layers, and report's pictures.

#include <functional>
#include <optional>
#include <string>

#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "stepmill/core/error.h"
#include "stepmill/part/part.h"

namespace stepmill {

/// The kernel's own form of a part: one valid closed solid in mm and part coordinates, its faces looking out
/// of the material. Shared by all copies of the part and never changed, so any thread may read it; who meshes
/// or moves it makes a copy of its own.
struct PartShape {
    TopoDS_Shape solid;
    /// From coordinates of the file to those of the part.
    Eigen::Matrix3d turned = Eigen::Matrix3d::Identity();
};

/// The normal of a plane, as its own frame has it, or the axis of a cylinder or cone; nothing for other
/// surfaces.
std::optional<Vec3> axisOf(const TopoDS_Face& face);

/// Wraps a solid made elsewhere (tests, sample parts) as a Part with its box, volume and faces.
/// \param solid  in mm; its coordinates become the part's
/// \throws Error(InvalidSolid) unless the shape is one valid closed solid, volume above 0.
Part makePart(const TopoDS_Shape& solid, const std::string& name);

/// What the chord of makeFacets() is.
enum class FacetChord { LengthMm, ShareOfEdge };

/// Puts facets on the faces of a shape of one's own, the same ones however many threads make them.
/// \param chord     how far a facet may be off its face, in mm or as a share of each edge's length
/// \param turn_rad  how far neighbouring facets of one face may turn
/// Cost: n log n in the nodes of a face of many loops.
void makeFacets(const TopoDS_Shape& shape, double chord, double turn_rad,
                FacetChord unit = FacetChord::LengthMm);

/// Calls `work` and turns the kernel's failures into Error(code, subject), but for running out of memory,
/// which stays std::bad_alloc. Other exceptions pass.
void guardOcct(ErrorCode code, const std::string& subject, const std::function<void()>& work);

}  // namespace stepmill
