// From planar regions back to solids.

#include "setup/prism_solid.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <gp_Circ.hxx>
#include <gp_Pln.hxx>
#include <StdFail_NotDone.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>

namespace stepmill::setup {

namespace {

/// Arcs no longer than this may be replaced by their chord [mm].
constexpr double kShortArcMm = 0.01;

gp_Pnt at(const Vec2& p, double z_mm) {
    return {p.x(), p.y(), z_mm};
}

/// Arc ends lie on their circle to within the grid only; the vertex says so, or OCCT refuses the edge.
TopoDS_Vertex vertexAt(const Vec2& p, double z_mm) {
    TopoDS_Vertex vertex;
    BRep_Builder().MakeVertex(vertex, at(p, z_mm), 2 * kGridMm);
    return vertex;
}

/// Seen from below, a circle with its normal downwards runs clockwise for us: so edges keep their direction.
gp_Circ circleOf(const Arc& arc, double z_mm) {
    const gp_Dir normal(0, 0, arc.ccw ? 1 : -1);
    return {gp_Ax2(at(arc.centre, z_mm), normal), arc.radius_mm};
}

/// OCCT refuses arcs hardly longer than their ends' tolerance; their chord is as good.
TopoDS_Edge edgeOf(const TopoDS_Vertex& from, const TopoDS_Vertex& to, const Segment& segment, double z_mm) {
    if (segment.arc) {
        BRepBuilderAPI_MakeEdge arc(circleOf(*segment.arc, z_mm), from, to);
        if (arc.IsDone()) return arc.Edge();
        const double chord_mm = BRep_Tool::Pnt(from).Distance(BRep_Tool::Pnt(to));
        if (chord_mm > kShortArcMm) throw StdFail_NotDone("an arc of a prism");
    }
    BRepBuilderAPI_MakeEdge line(from, to);
    if (!line.IsDone()) throw StdFail_NotDone("an edge of a prism");
    return line.Edge();
}

TopoDS_Edge fullCircle(const Vec2& from, const Arc& arc, double z_mm) {
    const Vec2 out = from - arc.centre;
    const gp_Ax2 axes(at(arc.centre, z_mm), gp_Dir(0, 0, arc.ccw ? 1 : -1), gp_Dir(out.x(), out.y(), 0));
    BRepBuilderAPI_MakeEdge made(gp_Circ(axes, arc.radius_mm));
    if (!made.IsDone()) throw StdFail_NotDone("a circle of a prism");
    return made.Edge();
}

TopoDS_Wire wireOf(const Loop& loop, double z_mm) {
    BRepBuilderAPI_MakeWire wire;
    const TopoDS_Vertex first = vertexAt(loop.start, z_mm);
    TopoDS_Vertex from = first;
    Vec2 from_point = loop.start;
    for (std::size_t i = 0; i < loop.segments.size(); ++i) {
        const Segment& segment = loop.segments[i];
        if (segment.arc && segment.to == from_point) {
            wire.Add(fullCircle(from_point, *segment.arc, z_mm));
            continue;
        }
        const TopoDS_Vertex to = i + 1 == loop.segments.size() ? first : vertexAt(segment.to, z_mm);
        wire.Add(edgeOf(from, to, segment, z_mm));
        from = to;
        from_point = segment.to;
    }
    if (!wire.IsDone()) throw StdFail_NotDone("a loop of a prism");
    return wire.Wire();
}

TopoDS_Face faceOf(const Region& component, double z_mm) {
    const gp_Pln plane(gp_Pnt(0, 0, z_mm), gp_Dir(0, 0, 1));
    const auto outer = std::find_if(component.loops.begin(), component.loops.end(),
                                    [](const Loop& loop) { return signedArea(loop) > 0; });
    BRepBuilderAPI_MakeFace face(plane, wireOf(*outer, z_mm));
    for (auto loop = component.loops.begin(); loop != component.loops.end(); ++loop)
        if (loop != outer) face.Add(wireOf(*loop, z_mm));
    if (!face.IsDone()) throw StdFail_NotDone("a face of a prism");
    return face.Face();
}

TopLoc_Location toPart(const Eigen::Isometry3d& part_to_setup) {
    const Eigen::Isometry3d back = part_to_setup.inverse();
    const Eigen::Matrix4d m = back.matrix();
    gp_Trsf transform;
    transform.SetValues(m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2), m(1, 3), m(2, 0),
                        m(2, 1), m(2, 2), m(2, 3));
    return {transform};
}

}  // namespace

TopoDS_Shape prismSolid(const Prism& prism, const Eigen::Isometry3d& part_to_setup) {
    TopoDS_Compound solids;
    BRep_Builder builder;
    builder.MakeCompound(solids);
    const gp_Vec up(0, 0, prism.top_z_mm - prism.bottom_z_mm);
    for (const Region& component : components(prism.region))
        builder.Add(solids, BRepPrimAPI_MakePrism(faceOf(component, prism.bottom_z_mm), up).Shape());
    return solids.Moved(toPart(part_to_setup));
}

}  // namespace stepmill::setup
