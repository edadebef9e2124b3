#pragma once

#include <optional>

#include <Geom_Curve.hxx>
#include <TopoDS_Edge.hxx>

namespace stepmill {

/// A line or circle in the sense of an edge's own curve, from the edge's first point to its last.
struct ElementaryCurve {
    Handle(Geom_Curve) curve;
    double first = 0;
    double last = 0;
};

/// The line or circle that an edge drawn as a spline is one of, to kSameForm_mm; nothing where none fits or
/// the edge is drawn as one already.
std::optional<ElementaryCurve> elementaryCurve(const TopoDS_Edge& edge);

}  // namespace stepmill
