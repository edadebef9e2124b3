#pragma once

#include <optional>

#include <Geom_ElementarySurface.hxx>
#include <TopoDS_Face.hxx>

namespace stepmill {

/// A plane, cylinder, cone, sphere or torus that a face lies on.
struct ElementarySurface {
    Handle(Geom_ElementarySurface) surface;
    bool turned = false;  ///< its normals look to the other side of those of the face's own surface
};

/// The elementary surface that a face drawn as a spline, or as something swept or turned, is one of: no point
/// of the face lies farther from it than kSameForm_mm and no normal leans from its own by more than
/// kSameForm_rad, both measured on a grid over the face. Nothing where none fits or the face is drawn as one
/// already.
///
/// Least squares over points and normals: all normals are one (plane), lie in a plane (cylinder), make one
/// angle with a direction (cone), meet in a point (sphere) or meet a line (torus).
std::optional<ElementarySurface> elementarySurface(const TopoDS_Face& face);

/// A tenth of a micron: what a file's rounding does, and below all that is machined [mm].
inline constexpr double kSameForm_mm = 1e-4;

/// A fillet of 10 mm that is kSameForm_mm deep over its chord leans by this much [rad].
inline constexpr double kSameForm_rad = 5e-4;

}  // namespace stepmill
