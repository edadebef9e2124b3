#include "solids.h"

#include <cmath>

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <GC_MakeArcOfCircle.hxx>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>
#include <ShapeUpgrade_RemoveLocations.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopTools_ListOfShape.hxx>

#include "stepmill/part/part_shape.h"

namespace stepmill {
namespace {

struct RoundedCorner {
    gp_Pnt start, middle, end;  ///< all equal for a sharp corner
    bool sharp = true;
};

RoundedCorner roundCorner(const Corner& before, const Corner& at, const Corner& after, double z) {
    const gp_Pnt corner(at.x_mm, at.y_mm, z);
    if (at.radius_mm <= 0) return {corner, corner, corner, true};
    const gp_Dir back(before.x_mm - at.x_mm, before.y_mm - at.y_mm, 0);
    const gp_Dir ahead(after.x_mm - at.x_mm, after.y_mm - at.y_mm, 0);
    const double half_angle = back.Angle(ahead) / 2;
    const double leg = at.radius_mm / std::tan(half_angle);
    const gp_Dir bisector(gp_Vec(back) + gp_Vec(ahead));
    const double to_centre = at.radius_mm / std::sin(half_angle);
    const auto along = [&](const gp_Dir& direction, double distance) {
        return corner.Translated(gp_Vec(direction) * distance);
    };
    return {along(back, leg), along(bisector, to_centre - at.radius_mm), along(ahead, leg), false};
}

TopoDS_Shape turned(const TopoDS_Shape& shape, const gp_Ax3& to) {
    gp_Trsf move;
    move.SetTransformation(to, gp_Ax3());
    return BRepBuilderAPI_Transform(shape, move, Standard_True).Shape();
}

TopTools_ListOfShape listOf(const std::vector<TopoDS_Shape>& shapes) {
    TopTools_ListOfShape list;
    for (const TopoDS_Shape& shape : shapes)
        list.Append(shape);
    return list;
}

template <class Operation>
TopoDS_Shape combine(const TopoDS_Shape& base, const std::vector<TopoDS_Shape>& tools) {
    if (tools.empty()) return base;
    TopTools_ListOfShape arguments;
    arguments.Append(base);
    Operation operation;
    operation.SetArguments(arguments);
    operation.SetTools(listOf(tools));
    operation.Build();
    if (operation.HasErrors())
        throw Error(ErrorCode::GeometryKernel, "sample part", "a Boolean operation failed");
    return operation.Shape();
}

}  // namespace

std::vector<Corner> rectangle(double x0, double y0, double x1, double y1, double radius) {
    return {{x0, y0, radius}, {x1, y0, radius}, {x1, y1, radius}, {x0, y1, radius}};
}

TopoDS_Shape prism(const std::vector<Corner>& outline, double z0, double z1) {
    std::vector<RoundedCorner> corners;
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i)
        corners.push_back(roundCorner(outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n], z0));

    BRepBuilderAPI_MakeWire wire;
    for (std::size_t i = 0; i < n; ++i) {
        const RoundedCorner& corner = corners[i];
        const RoundedCorner& next = corners[(i + 1) % n];
        if (!corner.sharp)
            wire.Add(
                BRepBuilderAPI_MakeEdge(GC_MakeArcOfCircle(corner.start, corner.middle, corner.end).Value()));
        if (corner.end.Distance(next.start) > 1e-9) wire.Add(BRepBuilderAPI_MakeEdge(corner.end, next.start));
    }
    const TopoDS_Shape face = BRepBuilderAPI_MakeFace(wire.Wire(), Standard_True).Shape();
    return BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, z1 - z0)).Shape();
}

TopoDS_Shape box(double x0, double y0, double z0, double x1, double y1, double z1) {
    return BRepPrimAPI_MakeBox(gp_Pnt(x0, y0, z0), gp_Pnt(x1, y1, z1)).Shape();
}

TopoDS_Shape cylinder(double x, double y, double diameter, double z0, double z1) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z0), gp::DZ()), diameter / 2, z1 - z0).Shape();
}

TopoDS_Shape facingX(const TopoDS_Shape& shape, double x, double y, double z) {
    return turned(shape, gp_Ax3(gp_Pnt(x, y, z), gp::DX(), gp::DY()));
}

TopoDS_Shape facingY(const TopoDS_Shape& shape, double x, double y, double z) {
    return turned(shape, gp_Ax3(gp_Pnt(x, y, z), gp::DY(), -gp::DX()));
}

TopoDS_Shape assemble(const TopoDS_Shape& base, const std::vector<TopoDS_Shape>& added,
                      const std::vector<TopoDS_Shape>& removed) {
    TopoDS_Shape solid;
    guardOcct(ErrorCode::GeometryKernel, "sample part", [&] {
        const TopoDS_Shape grown = combine<BRepAlgoAPI_Fuse>(base, added);
        const TopoDS_Shape cut = combine<BRepAlgoAPI_Cut>(grown, removed);
        ShapeUpgrade_UnifySameDomain unify(cut, Standard_True, Standard_True, Standard_False);
        unify.Build();
        // Prisms place their top by a location, which the STEP writer does not find back.
        ShapeUpgrade_RemoveLocations bake;
        bake.Remove(unify.Shape());
        solid = makePart(bake.GetResult(), "sample part").shape->solid;
    });
    return solid;
}

}  // namespace stepmill
