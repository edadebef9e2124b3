#include "part/measure.h"

#include <algorithm>

#include <Adaptor3d_Curve.hxx>
#include <Bnd_Box.hxx>
#include <BRep_Tool.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

namespace stepmill {
namespace {

/// The integrals refine each face until its share of the result changes by less than this. A fixed number of
/// points per face does not do: a spline that crowds its parameters at one place is then missed by parts in
/// 1e3, though the shape it draws is hardly another.
constexpr double kIntegrationShare = 1e-6;

/// Does the kernel integrate over the face piece by piece? Over what is swept from a spline it does not see
/// the spans, whatever is asked of it: a smooth wall of 40 of them was 5 % off.
bool isIntegrable(const TopoDS_Face& face) {
    const BRepAdaptor_Surface surface(face, Standard_False);
    switch (surface.GetType()) {
        case GeomAbs_SurfaceOfRevolution:
        case GeomAbs_SurfaceOfExtrusion:
            return surface.BasisCurve()->GetType() != GeomAbs_BSplineCurve;
        case GeomAbs_OffsetSurface:
            return false;
        default:
            return true;
    }
}

/// The shape; where a face is not integrable, a copy with spline surfaces.
TopoDS_Shape integrable(const TopoDS_Shape& shape) {
    const std::vector<TopoDS_Face> faces = facesOf(shape);
    if (std::all_of(faces.begin(), faces.end(), isIntegrable)) return shape;
    return BRepBuilderAPI_NurbsConvert(shape, true).Shape();
}

}  // namespace

std::string surfaceKind(const TopoDS_Face& face) {
    switch (BRepAdaptor_Surface(face, Standard_False).GetType()) {
        case GeomAbs_Plane:
            return "plane";
        case GeomAbs_Cylinder:
            return "cylinder";
        case GeomAbs_Cone:
            return "cone";
        case GeomAbs_Sphere:
            return "sphere";
        case GeomAbs_Torus:
            return "torus";
        case GeomAbs_BezierSurface:
            return "bezier";
        case GeomAbs_BSplineSurface:
            return "bspline";
        case GeomAbs_SurfaceOfRevolution:
            return "revolution";
        case GeomAbs_SurfaceOfExtrusion:
            return "extrusion";
        case GeomAbs_OffsetSurface:
            return "offset";
        default:
            return "other";
    }
}

bool isFreeForm(const TopoDS_Edge& edge) {
    if (BRep_Tool::Degenerated(edge)) return false;
    const GeomAbs_CurveType type = BRepAdaptor_Curve(edge).GetType();
    return type != GeomAbs_Line && type != GeomAbs_Circle && type != GeomAbs_Ellipse;
}

double volumeOf(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(integrable(shape), properties, kIntegrationShare);
    return properties.Mass();
}

double areaOf(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::SurfaceProperties(integrable(shape), properties, kIntegrationShare);
    return properties.Mass();
}

Box3 boxOf(const TopoDS_Shape& shape) {
    Bnd_Box box;
    BRepBndLib::AddOptimal(shape, box, Standard_False, Standard_False);
    Box3 result;
    if (box.IsVoid()) return result;
    box.SetGap(0);
    double x0, y0, z0, x1, y1, z1;
    box.Get(x0, y0, z0, x1, y1, z1);
    result.extend(Vec3(x0, y0, z0));
    result.extend(Vec3(x1, y1, z1));
    return result;
}

int countFreeEdges(const TopoDS_Shape& shape) {
    TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
    TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
    int count = 0;
    for (int i = 1; i <= faces_of_edge.Extent(); ++i) {
        const TopoDS_Edge edge = TopoDS::Edge(faces_of_edge.FindKey(i));
        const TopTools_ListOfShape& faces = faces_of_edge(i);
        if (faces.Extent() != 1 || BRep_Tool::Degenerated(edge)) continue;
        if (!BRep_Tool::IsClosed(edge, TopoDS::Face(faces.First()))) ++count;
    }
    return count;
}

int countEdges(const TopoDS_Shape& shape) {
    TopTools_IndexedMapOfShape edges;
    TopExp::MapShapes(shape, TopAbs_EDGE, edges);
    int count = 0;
    for (int i = 1; i <= edges.Extent(); ++i)
        count += BRep_Tool::Degenerated(TopoDS::Edge(edges(i))) ? 0 : 1;
    return count;
}

int countShapes(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
    TopTools_IndexedMapOfShape map;
    TopExp::MapShapes(shape, kind, map);
    return map.Extent();
}

std::vector<TopoDS_Face> facesOf(const TopoDS_Shape& shape) {
    std::vector<TopoDS_Face> faces;
    for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
        faces.push_back(TopoDS::Face(it.Current()));
    return faces;
}

TopoDS_Shape singleSolid(const TopoDS_Shape& shape, const std::string& subject) {
    if (shape.IsNull()) throw Error(ErrorCode::InvalidSolid, subject, "the shape is empty");
    if (shape.ShapeType() == TopAbs_SOLID) return shape;
    const int solids = countShapes(shape, TopAbs_SOLID);
    if (solids != 1 || TopExp_Explorer(shape, TopAbs_FACE, TopAbs_SOLID).More())
        throw Error(ErrorCode::InvalidSolid, subject,
                    "one solid expected, the shape holds " + std::to_string(solids) +
                        (solids == 1 ? " and loose faces" : ""));
    return TopExp_Explorer(shape, TopAbs_SOLID).Current();
}

void requireValid(const TopoDS_Shape& solid, double volume_mm3, const std::string& subject) {
    if (const int free_edges = countFreeEdges(solid); free_edges > 0)
        throw Error(ErrorCode::InvalidSolid, subject,
                    "the solid is not closed: " + std::to_string(free_edges) + " free edges");
    if (!BRepCheck_Analyzer(solid).IsValid())
        throw Error(ErrorCode::InvalidSolid, subject,
                    "the solid's faces, edges and vertices do not fit together");
    requireVolume(volume_mm3, subject);
}

void requireVolume(double volume_mm3, const std::string& subject) {
    if (!(volume_mm3 > 0))
        throw Error(ErrorCode::InvalidSolid, subject, "the solid's volume is not positive");
}

void describeShape(Part& part, const TopoDS_Shape& solid) {
    part.bbox_mm = boxOf(solid);
    part.volume_mm3 = volumeOf(solid);
    part.faces.clear();
    part.surfaces.clear();
    for (const TopoDS_Face& face : facesOf(solid)) {
        PartFace entry;
        entry.index = static_cast<int>(part.faces.size());
        entry.surface = surfaceKind(face);
        ++part.surfaces[entry.surface];
        part.faces.push_back(std::move(entry));
    }
    part.shape = std::make_shared<const PartShape>(PartShape{solid});
}

}  // namespace stepmill
