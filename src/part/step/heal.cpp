#include "part/step/heal.h"

#include <BRep_Tool.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepLib.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Precision.hxx>
#include <ShapeAnalysis_Surface.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeFix_Shape.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Solid.hxx>
#include <TopoDS_Vertex.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include <fmt/format.h>

#include "part/measure.h"
#include "part/mesh_check.h"
#include "part/occt_values.h"

namespace stepmill {
namespace {

constexpr int kSamplesPerEdge = 9;

/// More on an edge of many knots: each span may bulge by itself.
constexpr int kSamplesPerSpan = 3;
constexpr int kMostSamples = 400;

/// Worst distance of an edge's two vertices from the ends of its curve.
double vertexGap(const TopoDS_Edge& edge) {
    double first = 0;
    double last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    if (curve.IsNull()) return 0;
    TopoDS_Vertex start, end;
    TopExp::Vertices(edge, start, end);
    double gap = 0;
    if (!start.IsNull()) gap = std::max(gap, curve->Value(first).Distance(BRep_Tool::Pnt(start)));
    if (!end.IsNull()) gap = std::max(gap, curve->Value(last).Distance(BRep_Tool::Pnt(end)));
    return gap;
}

int samplesOf(const TopoDS_Edge& edge) {
    const int spans = BRepAdaptor_Curve(edge).NbIntervals(GeomAbs_CN);
    return std::clamp(kSamplesPerSpan * spans, kSamplesPerEdge, kMostSamples);
}

/// Worst distance of an edge's curve in space from a face's surface. The curve on the surface bounds it at
/// equal parameters; only where that bound is over the limit is the point projected, which costs more but
/// leaves out what is mere difference in parametrisation.
double edgeGap(const TopoDS_Edge& edge, const TopoDS_Face& face, double exact_mm) {
    double first = 0;
    double last = 0;
    const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
    double first_2d = 0;
    double last_2d = 0;
    const Handle(Geom2d_Curve) on_surface = BRep_Tool::CurveOnSurface(edge, face, first_2d, last_2d);
    if (curve.IsNull() || on_surface.IsNull()) return 0;
    const Handle(Geom_Surface) surface = BRep_Tool::Surface(face);
    double gap = 0;
    const int samples = samplesOf(edge);
    for (int i = 0; i < samples; ++i) {
        const double t = first + (last - first) * i / (samples - 1);
        const gp_Pnt2d uv = on_surface->Value(t);
        const gp_Pnt point = curve->Value(t);
        double distance = point.Distance(surface->Value(uv.X(), uv.Y()));
        if (distance > exact_mm) {
            ShapeAnalysis_Surface analysis(surface);
            analysis.NextValueOfUV(uv, point, Precision::Confusion());
            distance = std::min(distance, analysis.Gap());
        }
        gap = std::max(gap, distance);
    }
    return gap;
}

void noteFaces(const TopoDS_Shape& replacement, const std::string& name, ShapeNames& names) {
    if (replacement.IsNull()) return;
    for (TopExp_Explorer it(replacement, TopAbs_FACE); it.More(); it.Next())
        names.set(it.Current(), name);
}

TopoDS_Shape fixShape(const TopoDS_Shape& solid, const std::string& subject, ShapeNames& names,
                      std::vector<Remark>& remarks) {
    const double volume_before = volumeOf(solid);
    const int faces_before = countShapes(solid, TopAbs_FACE);
    ShapeFix_Shape fixer(solid);
    fixer.Perform();
    const TopoDS_Shape fixed = singleSolid(fixer.Shape(), subject);
    for (const TopoDS_Face& face : facesOf(solid)) {
        const std::string name = names.of(face);
        if (!name.empty()) noteFaces(fixer.Context()->Apply(face), name, names);
    }
    remarks.push_back(
        {kInputDoubt,
         fmt::format("healed: the solid was invalid; faces {} -> {}, volume {:.3f} -> {:.3f} mm3",
                     faces_before, countShapes(fixed, TopAbs_FACE), volume_before, volumeOf(fixed))});
    return fixed;
}

/// Files need not say how an edge runs on a plane, and the kernel projects it anew whenever it is asked for:
/// of a face with a thousand holes, that it looks at in pairs, millions of times.
void keepCurvesOnPlanes(const TopoDS_Shape& solid) {
    for (const TopoDS_Face& face : facesOf(solid)) {
        if (BRepAdaptor_Surface(face, Standard_False).GetType() != GeomAbs_Plane) continue;
        for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next())
            BRepLib::BuildPCurveForEdgeOnPlane(TopoDS::Edge(edges.Current()), face);
    }
}

}  // namespace

double largestGap(const Box3& box) {
    constexpr double kGap_mm = 0.02;
    constexpr double kGapShare = 2e-4;
    return std::max(kGap_mm, kGapShare * box.sizes().maxCoeff());
}

double doubtfulGap(const Box3& box) {
    constexpr double kGap_mm = 0.001;
    constexpr double kGapShare = 1e-4;
    return std::max(kGap_mm, kGapShare * box.sizes().maxCoeff());
}

Misfit measureMisfit(const TopoDS_Shape& solid, double exact_mm, double limit_mm) {
    Misfit misfit;
    TopTools_IndexedMapOfShape seen;
    for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next()) {
        const TopoDS_Face face = TopoDS::Face(faces.Current());
        for (TopExp_Explorer edges(face, TopAbs_EDGE); edges.More(); edges.Next()) {
            const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
            if (BRep_Tool::Degenerated(edge)) continue;
            const bool fresh = !seen.Contains(edge);
            seen.Add(edge);
            const double at_vertex = fresh ? vertexGap(edge) : 0;
            const double at_edge = edgeGap(edge, face, exact_mm);
            if (std::max(at_vertex, at_edge) > std::max(misfit.vertex_mm, misfit.edge_mm))
                misfit.where = toVec3(BRep_Tool::Pnt(TopExp::FirstVertex(edge)));
            misfit.vertices_off += at_vertex > limit_mm ? 1 : 0;
            misfit.edges_off += at_edge > limit_mm ? 1 : 0;
            misfit.vertex_mm = std::max(misfit.vertex_mm, at_vertex);
            misfit.edge_mm = std::max(misfit.edge_mm, at_edge);
        }
    }
    return misfit;
}

HealedSolid healSolid(const TopoDS_Shape& solid, const std::string& subject, ShapeNames& names,
                      std::vector<Remark>& remarks) {
    if (const int free_edges = countFreeEdges(solid); free_edges > 0)
        throw Error(ErrorCode::OpenShell, subject,
                    fmt::format("the solid has {} free edges: it is not closed", free_edges));
    keepCurvesOnPlanes(solid);
    TopoDS_Shape healed = solid;
    if (!BRepCheck_Analyzer(solid).IsValid()) healed = fixShape(solid, subject, names, remarks);
    double volume_mm3 = volumeOf(healed);
    if (volume_mm3 < 0) {
        TopoDS_Solid turned = TopoDS::Solid(healed);
        BRepLib::OrientClosedSolid(turned);
        healed = turned;
        volume_mm3 = -volume_mm3;
        remarks.push_back({kInputDoubt, "healed: the solid was inside out and has been turned"});
    }
    if (healed.IsEqual(solid))
        requireVolume(volume_mm3, subject);
    else
        requireValid(healed, volume_mm3, subject);
    requireMesh(healed, volume_mm3, subject);
    return {healed, volume_mm3};
}

TopoDS_Shape scaleSolid(const TopoDS_Shape& solid, double factor, ShapeNames& names) {
    gp_Trsf scale;
    scale.SetScale(gp_Pnt(0, 0, 0), factor);
    BRepBuilderAPI_Transform transform(solid, scale, Standard_True);
    for (const TopoDS_Face& face : facesOf(solid))
        noteFaces(transform.ModifiedShape(face), names.of(face), names);
    return transform.Shape();
}

}  // namespace stepmill
