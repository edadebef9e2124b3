#pragma once

#include <string>
#include <vector>

#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "stepmill/part/part_shape.h"

namespace stepmill {

/// "plane", "cylinder", ... as PartFace::surface says it.
std::string surfaceKind(const TopoDS_Face& face);

/// Is the edge neither degenerated nor a line, a circle or an ellipse?
bool isFreeForm(const TopoDS_Edge& edge);

/// Signed volume by integrals over the faces, to about 1e-6 of itself [mm3]; negative for a solid whose faces
/// look inwards.
double volumeOf(const TopoDS_Shape& shape);

/// Of all faces, to about 1e-6 [mm2].
double areaOf(const TopoDS_Shape& shape);

/// Tight box of the shape itself, without OCCT's tolerances around it [mm].
Box3 boxOf(const TopoDS_Shape& shape);

/// Edges that bound one face only; a seam or a degenerated edge is none.
int countFreeEdges(const TopoDS_Shape& shape);

/// Each once, without degenerated ones.
int countEdges(const TopoDS_Shape& shape);

int countShapes(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind);

/// Faces in the order of TopExp_Explorer.
std::vector<TopoDS_Face> facesOf(const TopoDS_Shape& shape);

/// The shape itself if it is a solid, else the only solid of a compound that holds nothing else.
/// \throws Error(InvalidSolid)
TopoDS_Shape singleSolid(const TopoDS_Shape& shape, const std::string& subject);

/// \param volume_mm3  of the solid; costly to measure, so callers that know it say it
/// \throws Error(InvalidSolid) for free edges, if BRepCheck finds fault or the volume is not positive.
void requireValid(const TopoDS_Shape& solid, double volume_mm3, const std::string& subject);
/// \throws Error(InvalidSolid) if the volume is not positive.
void requireVolume(double volume_mm3, const std::string& subject);

/// Fills box, volume, faces (without names), surfaces and shape.
void describeShape(Part& part, const TopoDS_Shape& solid);

}  // namespace stepmill
