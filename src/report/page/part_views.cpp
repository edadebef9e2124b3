// Views of the part by hidden-line removal.

#include "stepmill/report/part_views.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepBuilderAPI_Transform.hxx>
#include <BRepLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <GCPnts_TangentialDeflection.hxx>
#include <gp_Ax2.hxx>
#include <gp_Trsf.hxx>
#include <HLRAlgo_Projector.hxx>
#include <HLRBRep_Algo.hxx>
#include <HLRBRep_HLRToShape.hxx>
#include <HLRBRep_PolyAlgo.hxx>
#include <HLRBRep_PolyHLRToShape.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>

#include "report/page/drawing.h"
#include "report/page/part_drawings.h"
#include "report/page/shading.h"
#include "stepmill/part/part_shape.h"

namespace stepmill {

namespace report {
namespace {

/// Exact hidden lines grow with the square of the faces; beyond this many the facets do.
constexpr int kMostFacesForExactLines = 120;
/// Chord error of drawn curves as a share of the part's size.
constexpr double kDrawingDeflection = 5e-4;

struct Eye {
    const char* title;
    gp_Dir towards_viewer;
    gp_Dir right;
};

using Polyline = std::vector<Vec2>;

gp_Trsf toTrsf(const Eigen::Isometry3d& transform) {
    const Eigen::Matrix4d& m = transform.matrix();
    gp_Trsf trsf;
    trsf.SetValues(m(0, 0), m(0, 1), m(0, 2), m(0, 3), m(1, 0), m(1, 1), m(1, 2), m(1, 3), m(2, 0), m(2, 1),
                   m(2, 2), m(2, 3));
    return trsf;
}

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

struct Lines {
    std::vector<Polyline> visible;
    std::vector<Polyline> hidden;

    void addVisible(const TopoDS_Shape& edges, double deflection_mm) {
        append(visible, edges, deflection_mm);
    }
    void addHidden(const TopoDS_Shape& edges, double deflection_mm) { append(hidden, edges, deflection_mm); }

  private:
    static void append(std::vector<Polyline>& to, TopoDS_Shape edges, double deflection_mm) {
        if (edges.IsNull()) return;
        BRepLib::BuildCurves3d(edges);
        for (Polyline& line : polylines(edges, deflection_mm))
            to.push_back(std::move(line));
    }
};

/// Sharp edges and outlines, visible and hidden; smooth edges are left out.
template <typename Shapes>
Lines sharpAndOutlines(Shapes& shapes, double deflection_mm) {
    Lines lines;
    lines.addVisible(shapes.VCompound(), deflection_mm);
    lines.addVisible(shapes.OutLineVCompound(), deflection_mm);
    lines.addHidden(shapes.HCompound(), deflection_mm);
    lines.addHidden(shapes.OutLineHCompound(), deflection_mm);
    return lines;
}

Lines exactLines(const TopoDS_Shape& solid, const HLRAlgo_Projector& projector, double deflection_mm) {
    Handle(HLRBRep_Algo) algorithm = new HLRBRep_Algo();
    algorithm->Add(solid);
    algorithm->Projector(projector);
    algorithm->Update();
    algorithm->Hide();
    HLRBRep_HLRToShape shapes(algorithm);
    return sharpAndOutlines(shapes, deflection_mm);
}

Lines facetLines(const TopoDS_Shape& solid, const HLRAlgo_Projector& projector, double deflection_mm) {
    Handle(HLRBRep_PolyAlgo) algorithm = new HLRBRep_PolyAlgo();
    algorithm->Load(solid);
    algorithm->Projector(projector);
    algorithm->Update();
    HLRBRep_PolyHLRToShape shapes;
    shapes.Update(algorithm);
    return sharpAndOutlines(shapes, deflection_mm);
}

Element drawn(const Lines& lines, const Shading& shading, std::string label) {
    Box2 box;
    for (const std::vector<Polyline>* group : {&lines.visible, &lines.hidden})
        for (const Polyline& line : *group)
            for (const Vec2& p : line)
                box.extend(p);
    Drawing drawing(box, std::move(label));
    for (const auto& [tint, patches] : shading)
        drawing.polylines(patches, "shade " + tintClass(tint));
    drawing.polylines(lines.hidden, "hidden");
    drawing.polylines(lines.visible, "visible");
    return std::move(drawing).element();
}

/// The solid as it stands in the setup: a copy, since meshing writes into the shape and the part is shared.
TopoDS_Shape solidIn(const Part& part, const Eigen::Isometry3d& part_to_setup) {
    return BRepBuilderAPI_Transform(part.shape->solid, toTrsf(part_to_setup), true).Shape();
}

const std::vector<Eye>& eyes() {
    static const std::vector<Eye> all{{"Top", gp_Dir(0, 0, 1), gp_Dir(1, 0, 0)},
                                      {"Front", gp_Dir(0, -1, 0), gp_Dir(1, 0, 0)},
                                      {"Right", gp_Dir(1, 0, 0), gp_Dir(0, 1, 0)},
                                      {"Isometric", gp_Dir(1, -1, 1), gp_Dir(1, 1, 0)}};
    return all;
}

std::vector<PartDrawing> drawAll(const Part& part, const TopoDS_Shape& solid, const std::vector<int>& tints) {
    constexpr double kAngularDeflection = 0.2;
    const double deflection_mm = kDrawingDeflection * part.bbox_mm.diagonal().norm();
    const bool exact = static_cast<int>(part.faces.size()) <= kMostFacesForExactLines;
    // Exact hidden lines would be disturbed by facets that were there before them.
    if (!exact) BRepMesh_IncrementalMesh(solid, deflection_mm, false, kAngularDeflection);
    std::vector<Lines> lines;
    for (const Eye& eye : eyes()) {
        const HLRAlgo_Projector projector(gp_Ax2(gp_Pnt(0, 0, 0), eye.towards_viewer, eye.right));
        lines.push_back(exact ? exactLines(solid, projector, deflection_mm)
                              : facetLines(solid, projector, deflection_mm));
    }
    if (exact && !tints.empty()) BRepMesh_IncrementalMesh(solid, deflection_mm, false, kAngularDeflection);
    std::vector<PartDrawing> drawings;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const Eye& eye = eyes()[i];
        const Shading shading =
            tints.empty() ? Shading{} : shade(solid, eye.towards_viewer, eye.right, tints);
        drawings.push_back({eye.title, drawn(lines[i], shading, std::string(eye.title) + " view")});
    }
    return drawings;
}

}  // namespace

std::vector<PartDrawing> partDrawings(const Part& part, const Eigen::Isometry3d& part_to_setup,
                                      const std::vector<int>& tints) {
    STEPMILL_CHECK(tints.empty() || tints.size() == part.faces.size(), "one tint a face");
    std::vector<PartDrawing> drawings;
    guardOcct(ErrorCode::GeometryKernel, "views of " + part.name,
              [&] { drawings = drawAll(part, solidIn(part, part_to_setup), tints); });
    return drawings;
}

Element figuresOf(std::vector<PartDrawing> drawings) {
    Element pairs("div.pairs.views");
    for (PartDrawing& view : drawings)
        pairs.add(Element("figure", std::move(view.drawing), Element("figcaption", view.title)));
    return pairs;
}

}  // namespace report

namespace {

std::vector<View> asText(const std::vector<report::PartDrawing>& drawings) {
    std::vector<View> views;
    for (const report::PartDrawing& view : drawings)
        views.push_back({view.title, view.drawing.markup()});
    return views;
}

}  // namespace

std::vector<View> partViews(const Part& part, const Eigen::Isometry3d& part_to_setup) {
    return asText(report::partDrawings(part, part_to_setup));
}

std::vector<View> shadedViews(const Part& part, const Eigen::Isometry3d& part_to_setup,
                              const std::vector<int>& tints) {
    return asText(report::partDrawings(part, part_to_setup, tints));
}

}  // namespace stepmill
