#include "support/form_solids.h"

#include <cmath>

#include <BRep_Tool.hxx>
#include <BRepAlgoAPI_Common.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <Geom_BSplineCurve.hxx>
#include <GeomAPI_Interpolate.hxx>
#include <gp_Ax2.hxx>
#include <Standard_Failure.hxx>
#include <TColgp_HArray1OfPnt.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Wire.hxx>

#include "solids.h"
#include "stepmill/core/error.h"
#include "stepmill/core/units.h"

namespace stepmill::test {
namespace {

/// The kernel's own failures as ours.
template <typename Make>
TopoDS_Shape made(Make make) {
    try {
        const TopoDS_Shape shape = make();
        if (!shape.IsNull()) return shape;
    } catch (const Standard_Failure&) {
        // told below
    }
    throw Error(ErrorCode::GeometryKernel, "form solid", "the kernel makes none");
}

/// A rectangle with rounded corners as one wire; each corner one edge, however small.
TopoDS_Wire outlineWire(const Rounded& at, double z) {
    const double r = at.radius;
    BRepBuilderAPI_MakeWire wire;
    const gp_Pnt sides[4][2] = {{{at.x0 + r, at.y0, z}, {at.x1 - r, at.y0, z}},
                                {{at.x1, at.y0 + r, z}, {at.x1, at.y1 - r, z}},
                                {{at.x1 - r, at.y1, z}, {at.x0 + r, at.y1, z}},
                                {{at.x0, at.y1 - r, z}, {at.x0, at.y0 + r, z}}};
    const gp_Pnt centres[4] = {{at.x1 - r, at.y0 + r, z},
                               {at.x1 - r, at.y1 - r, z},
                               {at.x0 + r, at.y1 - r, z},
                               {at.x0 + r, at.y0 + r, z}};
    for (int i = 0; i < 4; ++i) {
        wire.Add(BRepBuilderAPI_MakeEdge(sides[i][0], sides[i][1]).Edge());
        if (r <= 0) continue;
        const gp_Circ corner(gp_Ax2(centres[i], gp::DZ()), r);
        wire.Add(BRepBuilderAPI_MakeEdge(corner, sides[i][1], sides[(i + 1) % 4][0]).Edge());
    }
    return wire.Wire();
}

TopoDS_Shape lofted(const TopoDS_Wire& floor, const TopoDS_Wire& top) {
    BRepOffsetAPI_ThruSections loft(Standard_True, Standard_True);
    loft.AddWire(floor);
    loft.AddWire(top);
    return loft.Shape();
}

opencascade::handle<Geom_BSplineCurve> splineThrough(const std::vector<gp_Pnt>& points, bool closed) {
    const opencascade::handle<TColgp_HArray1OfPnt> array =
        new TColgp_HArray1OfPnt(1, static_cast<int>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
        array->SetValue(static_cast<int>(i) + 1, points[i]);
    GeomAPI_Interpolate interpolate(array, closed, 1e-6);
    interpolate.Perform();
    return interpolate.Curve();
}

TopoDS_Wire closedSpline(double x, double y, const std::vector<double>& reaches, double share, double z) {
    std::vector<gp_Pnt> points;
    for (std::size_t i = 0; i < reaches.size(); ++i) {
        const double angle = 2 * kPi * static_cast<double>(i) / static_cast<double>(reaches.size());
        points.emplace_back(x + share * reaches[i] * std::cos(angle),
                            y + share * reaches[i] * std::sin(angle), z);
    }
    return BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(splineThrough(points, true)).Edge()).Wire();
}

bool liesAt(const TopoDS_Edge& edge, double z) {
    double first = 0, last = 0;
    const opencascade::handle<Geom_Curve> curve = BRep_Tool::Curve(edge, first, last);
    for (const double t : {first, (first + last) / 2, last})
        if (std::abs(curve->Value(t).Z() - z) > 1e-9) return false;
    return true;
}

}  // namespace

TopoDS_Shape drafted(const Rounded& floor, double floor_z, double top_z, double draft_deg) {
    return made([&] {
        const double by = (top_z - floor_z) * std::tan(degToRad(draft_deg));
        const Rounded top{floor.x0 - by, floor.y0 - by, floor.x1 + by, floor.y1 + by,
                          floor.radius > 0 ? floor.radius + by : 0};
        return lofted(outlineWire(floor, floor_z), outlineWire(top, top_z));
    });
}

TopoDS_Shape roundFloored(const Rounded& outline, double floor_z, double top_z, double fillet) {
    return made([&] {
        const TopoDS_Shape upright =
            prism(rectangle(outline.x0, outline.y0, outline.x1, outline.y1, outline.radius), floor_z, top_z);
        BRepFilletAPI_MakeFillet rounding(upright);
        for (TopExp_Explorer it(upright, TopAbs_EDGE); it.More(); it.Next())
            if (liesAt(TopoDS::Edge(it.Current()), floor_z)) rounding.Add(fillet, TopoDS::Edge(it.Current()));
        return rounding.Shape();
    });
}

TopoDS_Shape channel(double x0, double x1, double y, double diameter, double bottom_z, double top_z) {
    const double r = diameter / 2;
    const TopoDS_Shape round =
        BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x0, y, bottom_z + r), gp::DX()), r, x1 - x0).Shape();
    return assemble(round, {box(x0, y - r, bottom_z + r, x1, y + r, top_z)}, {});
}

TopoDS_Shape dimple(double x, double y, double radius, double bottom_z) {
    return BRepPrimAPI_MakeSphere(gp_Pnt(x, y, bottom_z + radius), radius).Shape();
}

TopoDS_Shape splineSided(double x, double y, const std::vector<double>& reaches, double floor_z, double top_z,
                         double top_share) {
    return made([&] {
        return lofted(closedSpline(x, y, reaches, 1, floor_z), closedSpline(x, y, reaches, top_share, top_z));
    });
}

TopoDS_Shape splineFloored(double x0, double x1, double y0, double y1, const std::vector<double>& heights,
                           double top_z) {
    return made([&] {
        std::vector<gp_Pnt> points;
        for (std::size_t i = 0; i < heights.size(); ++i)
            points.emplace_back(
                x0 + (x1 - x0) * static_cast<double>(i) / static_cast<double>(heights.size() - 1), y0,
                heights[i]);
        const gp_Pnt corners[2] = {{x1, y0, top_z}, {x0, y0, top_z}};
        BRepBuilderAPI_MakeWire wire(BRepBuilderAPI_MakeEdge(splineThrough(points, false)).Edge());
        wire.Add(BRepBuilderAPI_MakeEdge(points.back(), corners[0]).Edge());
        wire.Add(BRepBuilderAPI_MakeEdge(corners[0], corners[1]).Edge());
        wire.Add(BRepBuilderAPI_MakeEdge(corners[1], points.front()).Edge());
        return BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(wire.Wire(), true).Face(), gp_Vec(0, y1 - y0, 0))
            .Shape();
    });
}

}  // namespace stepmill::test
