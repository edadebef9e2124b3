#pragma once

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeWedge.hxx>
#include <gp_Ax2.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Solid.hxx>

#include "stepmill/layers/layer_stack.h"
#include "stepmill/part/part_shape.h"

namespace stepmill::test {

inline TopoDS_Shape box(double x, double y, double z, double dx, double dy, double dz) {
    return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), dx, dy, dz).Shape();
}
inline TopoDS_Shape cylinder(double x, double y, double z, double radius, double height) {
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, y, z), gp::DZ()), radius, height).Shape();
}
inline TopoDS_Shape cut(const TopoDS_Shape& a, const TopoDS_Shape& b) {
    return BRepAlgoAPI_Cut(a, b).Shape();
}
inline Part part(const TopoDS_Shape& shape) {
    return makePart(TopoDS::Solid(TopExp_Explorer(shape, TopAbs_SOLID).Current()), "test");
}
inline Setup setupOf(const Part& part, const Vec3& axis = Vec3::UnitZ(), const StockMargin& margin = {}) {
    SetupRequest request;
    request.axes = {axis};
    request.margin = margin;
    return chooseSetups(part, request).front();
}
inline LayerStack sliced(const TopoDS_Shape& shape, const Vec3& axis = Vec3::UnitZ(),
                         const SliceOptions& options = {}) {
    return slice(setupOf(part(shape), axis), Tolerances{}, options);
}
/// Every level parts two slabs.
inline SliceOptions allLevels() {
    SliceOptions options;
    options.join_slabs = false;
    return options;
}

}  // namespace stepmill::test
