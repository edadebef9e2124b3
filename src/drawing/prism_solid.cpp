#include "drawing/prism_solid.h"

#include <fmt/format.h>
#include <BRep_Builder.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <gp_Ax2.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopTools_ListOfShape.hxx>

#include "drawing/spline_points.h"
#include "stepmill/core/error.h"
#include "stepmill/part/part_shape.h"

namespace stepmill::drawing {
namespace {

/// Cuts go on so far beyond the part where they leave it [mm].
constexpr double kBeyondMm = 1;

gp_Pnt pointAt(const Vec2& p) {
    return {p.x(), p.y(), 0};
}

TopoDS_Edge edgeOf(const Stroke& stroke) {
    const gp_Dir up(0, 0, 1);
    if (stroke.isCircle())
        return BRepBuilderAPI_MakeEdge(gp_Circ(gp_Ax2(pointAt(stroke.from), up), stroke.circle_radius));
    if (stroke.spline) return BRepBuilderAPI_MakeEdge(kernelSpline(*stroke.spline));
    if (stroke.bulge == 0) return BRepBuilderAPI_MakeEdge(pointAt(stroke.from), pointAt(stroke.to));
    const Arc arc = arcOf(stroke);
    const gp_Circ circle(gp_Ax2(pointAt(arc.centre), arc.ccw ? up : up.Reversed()), arc.radius_mm);
    return BRepBuilderAPI_MakeEdge(circle, pointAt(stroke.from), pointAt(stroke.to));
}

TopoDS_Wire wireOf(const Profile& profile, const std::string& file) {
    BRepBuilderAPI_MakeWire wire;
    for (const Stroke& stroke : profile.strokes) {
        wire.Add(edgeOf(stroke));
        if (!wire.IsDone())
            refuse(file, fmt::format("layer '{}', {}", stroke.layer, stroke.place),
                   "expected a profile that the geometry kernel can close");
    }
    return wire.Wire();
}

TopoDS_Shape prism(const ProfileArea& area, double bottom_mm, double top_mm, const std::string& file) {
    BRepBuilderAPI_MakeFace face(gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), wireOf(area.outer, file));
    for (const Profile& hole : area.holes)
        face.Add(TopoDS::Wire(wireOf(hole, file).Reversed()));
    if (!face.IsDone()) throw Error(ErrorCode::GeometryKernel, file, "a profile makes no face");
    gp_Trsf down;
    down.SetTranslation(gp_Vec(0, 0, bottom_mm));
    const TopoDS_Shape base = face.Face().Moved(TopLoc_Location(down));
    return BRepPrimAPI_MakePrism(base, gp_Vec(0, 0, top_mm - bottom_mm)).Shape();
}

TopoDS_Shape cut(const TopoDS_Shape& from, const TopTools_ListOfShape& tools, const std::string& file) {
    if (tools.IsEmpty()) return from;
    TopTools_ListOfShape arguments;
    arguments.Append(from);
    BRepAlgoAPI_Cut operation;
    operation.SetArguments(arguments);
    operation.SetTools(tools);
    operation.Build();
    if (operation.HasErrors()) throw Error(ErrorCode::GeometryKernel, file, "its profiles could not be cut");
    return operation.Shape();
}

}  // namespace

TopoDS_Shape prismSolid(const std::vector<ProfileArea>& outline, double thickness_mm,
                        const std::vector<Pocketing>& pocketings, const std::string& file) {
    TopoDS_Shape result;
    guardOcct(ErrorCode::InvalidSolid, file, [&] {
        if (outline.size() != 1) throw Error(ErrorCode::Internal, file, "a part of several outlines");
        const TopoDS_Shape block = prism(outline.front(), -thickness_mm, 0, file);
        TopTools_ListOfShape tools;
        for (const Pocketing& pocketing : pocketings) {
            const bool through = pocketing.depth_mm >= thickness_mm;
            const double bottom_mm = through ? -thickness_mm - kBeyondMm : -pocketing.depth_mm;
            for (const ProfileArea& area : pocketing.areas)
                tools.Append(prism(area, bottom_mm, kBeyondMm, file));
        }
        // Faces that pockets beside each other cut in pieces are one again.
        ShapeUpgrade_UnifySameDomain unify(cut(block, tools, file), true, true, false);
        unify.Build();
        result = unify.Shape();
    });
    return result;
}

}  // namespace stepmill::drawing
