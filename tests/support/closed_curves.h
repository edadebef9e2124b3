#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <Geom_BSplineCurve.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopoDS_Shape.hxx>

namespace stepmill::test {

/// A periodic spline in z = 0 through points all round its centre, at these distances from it.
inline Handle(Geom_BSplineCurve)
    closedSpline(const std::vector<double>& radii_mm, const gp_Pnt& centre = gp::Origin()) {
    const int count = static_cast<int>(radii_mm.size());
    const Handle(TColgp_HArray1OfPnt) points = new TColgp_HArray1OfPnt(1, count);
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * i / count;
        points->SetValue(i + 1, gp_Pnt(centre.X() + radii_mm[i] * std::cos(angle),
                                       centre.Y() + radii_mm[i] * std::sin(angle), 0));
    }
    GeomAPI_Interpolate spline(points, true, 1e-7);
    spline.Perform();
    return spline.Curve();
}

/// Upright from z = 0, inside one closed edge.
inline TopoDS_Shape prismIn(const TopoDS_Edge& edge, double height_mm) {
    const TopoDS_Wire wire = BRepBuilderAPI_MakeWire(edge).Wire();
    return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire, true).Face(), gp_Vec(0, 0, height_mm)).Shape();
}

}  // namespace stepmill::test
