#include "report/page/hidden_lines.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepLib.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <HLRBRep_PolyAlgo.hxx>
#include <HLRBRep_PolyHLRToShape.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include "stepmill/part/part_shape.h"

namespace stepmill::report {
namespace {

/// Hidden-line edges lie in the plane z = 0 of the view.
std::vector<Polyline> polylines(const TopoDS_Shape& edges, double deflection_mm) {
    std::vector<Polyline> lines;
    if (edges.IsNull()) return lines;
    for (TopExp_Explorer at(edges, TopAbs_EDGE); at.More(); at.Next()) {
        const BRepAdaptor_Curve curve(TopoDS::Edge(at.Current()));
        constexpr double kAngularDeflection = 0.1;
        const GCPnts_TangentialDeflection points(curve, kAngularDeflection, deflection_mm);
        Polyline line;
        for (int i = 1; i <= points.NbPoints(); ++i)
            line.emplace_back(points.Value(i).X(), points.Value(i).Y());
        lines.push_back(std::move(line));
    }
    return lines;
}

void append(std::vector<Polyline>& to, const TopoDS_Shape& edges, double deflection_mm) {
    if (edges.IsNull()) return;
    BRepLib::BuildCurves3d(edges);
    for (Polyline& line : polylines(edges, deflection_mm))
        to.push_back(std::move(line));
}

}  // namespace

gp_Trsf toTrsf(const Eigen::Isometry3d& transform) {
    const Eigen::Matrix4d& m = transform.matrix();
    gp_Trsf trsf;
    trsf.SetValues(m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2), m(1, 3), m(2, 0), m(2, 1),
                   m(2, 2), m(2, 3));
    return trsf;
}

Lines hiddenLines(const TopoDS_Shape& solid, const HLRAlgo_Projector& projector, double deflection_mm) {
    Handle(HLRBRep_PolyAlgo) algorithm = new HLRBRep_PolyAlgo();
    algorithm->Load(solid);
    algorithm->Projector(projector);
    algorithm->Update();
    HLRBRep_PolyHLRToShape shapes;
    shapes.Update(algorithm);
    Lines lines;
    append(lines.visible, shapes.VCompound(), deflection_mm);
    append(lines.visible, shapes.OutLineVCompound(), deflection_mm);
    append(lines.hidden, shapes.HCompound(), deflection_mm);
    append(lines.hidden, shapes.OutLineHCompound(), deflection_mm);
    return lines;
}

TopoDS_Shape solidIn(const PartShape& shape, const Eigen::Isometry3d& part_to_setup) {
    return BRepBuilderAPI_Transform(shape.solid, toTrsf(part_to_setup), true).Shape();
}

TopoDS_Shape solidIn(const Part& part, const Eigen::Isometry3d& part_to_setup) {
    return solidIn(*part.shape, part_to_setup);
}

}  // namespace stepmill::report
