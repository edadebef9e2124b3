// A part's faces as plain values.

#include "stepmill/part/face_graph.h"

#include <BRep_Tool.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRepTopAdaptor_FClass2d.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <Geom2d_Curve.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "part/face_sample.h"
#include "part/measure.h"
#include "stepmill/core/units.h"
#include "stepmill/part/part_shape.h"

namespace stepmill {

namespace {

Vec3 vec(const gp_XYZ& p) {
    return {p.X(), p.Y(), p.Z()};
}

struct ParameterBox {
    double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
};

ParameterBox parameters(const TopoDS_Face& face) {
    ParameterBox box;
    BRepTools::UVBounds(face, box.u0, box.u1, box.v0, box.v1);
    return box;
}

/// Points of a grid over the parameters that lie inside the face, the coarsest grid that has some.
std::vector<FaceSample> samplesOf(const TopoDS_Face& face, const BRepAdaptor_Surface& surface) {
    const ParameterBox box = parameters(face);
    BRepTopAdaptor_FClass2d inside(face, Precision::PConfusion());
    std::vector<FaceSample> samples;
    // Odd and even by turns: a grid that misses a narrow face in its middle is followed by one that does not.
    constexpr std::array<int, 4> kSteps{5, 12, 33, 90};
    constexpr std::size_t kEnough = 3;
    for (const int steps : kSteps) {
        for (int i = 0; i < steps && samples.size() < static_cast<std::size_t>(steps) * steps; ++i) {
            for (int j = 0; j < steps; ++j) {
                const double u = box.u0 + (box.u1 - box.u0) * (i + 0.5) / steps;
                const double v = box.v0 + (box.v1 - box.v0) * (j + 0.5) / steps;
                if (inside.Perform(gp_Pnt2d(u, v)) != TopAbs_IN) continue;
                const FaceSample sample = sampleAt(face, surface, u, v);
                if (!sample.normal.isZero()) samples.push_back(sample);
            }
        }
        if (samples.size() >= kEnough) break;
    }
    return samples;
}

void describeRound(FaceShape& shape, const gp_Ax1& axis) {
    shape.origin = vec(axis.Location().XYZ());
    shape.axis = vec(axis.Direction().XYZ());
}

/// Does the normal at a sample point towards the axis (or centre)?
bool pointsInwards(const FaceShape& shape, const Vec3& towards) {
    if (shape.samples.empty()) return false;
    return shape.samples.front().normal.dot(towards) > 0;
}

Vec3 towardsAxis(const FaceShape& shape, const Vec3& at) {
    const Vec3 from = shape.origin - at;
    return from - from.dot(shape.axis) * shape.axis;
}

void describeSurface(FaceShape& shape, const BRepAdaptor_Surface& surface, const ParameterBox& box) {
    const Vec3 at = shape.samples.empty() ? Vec3(Vec3::Zero()) : shape.samples.front().at;
    switch (surface.GetType()) {
        case GeomAbs_Plane:
            shape.origin = vec(surface.Plane().Location().XYZ());
            if (!shape.samples.empty()) shape.axis = shape.samples.front().normal;
            break;
        case GeomAbs_Cylinder:
            describeRound(shape, surface.Cylinder().Axis());
            shape.radius_mm = surface.Cylinder().Radius();
            shape.angle_rad = box.u1 - box.u0;
            shape.hollow = pointsInwards(shape, towardsAxis(shape, at));
            break;
        case GeomAbs_Cone:
            describeRound(shape, surface.Cone().Axis());
            shape.origin = vec(surface.Cone().Apex().XYZ());
            shape.half_angle_rad = std::abs(surface.Cone().SemiAngle());
            shape.angle_rad = box.u1 - box.u0;
            shape.hollow = pointsInwards(shape, towardsAxis(shape, at));
            break;
        case GeomAbs_Sphere:
            shape.origin = vec(surface.Sphere().Location().XYZ());
            shape.radius_mm = surface.Sphere().Radius();
            shape.hollow = pointsInwards(shape, shape.origin - at);
            break;
        case GeomAbs_Torus: {
            describeRound(shape, surface.Torus().Axis());
            shape.radius_mm = surface.Torus().MinorRadius();
            const Vec3 in = towardsAxis(shape, at);
            const Vec3 tube_centre = shape.origin - in.normalized() * surface.Torus().MajorRadius();
            shape.hollow = pointsInwards(shape, tube_centre - at);
            break;
        }
        default:
            break;
    }
}

void addOutline(FaceShape& shape, const TopoDS_Face& face) {
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
        const TopoDS_Edge edge = TopoDS::Edge(it.Current());
        if (BRep_Tool::Degenerated(edge)) {
            shape.pointed = shape.surface == "cone";
            continue;
        }
        const BRepAdaptor_Curve curve(edge);
        const double from = curve.FirstParameter();
        const double to = curve.LastParameter();
        for (const double share : {0.0, 0.5, 1.0})
            shape.outline.push_back(vec(curve.Value(from + share * (to - from)).XYZ()));
    }
}

FaceShape shapeOf(const TopoDS_Face& face, const PartFace& entry) {
    FaceShape shape;
    shape.index = entry.index;
    shape.surface = entry.surface;
    const BRepAdaptor_Surface surface(face, Standard_False);
    shape.samples = samplesOf(face, surface);
    describeSurface(shape, surface, parameters(face));
    shape.area_mm2 = areaOf(face);
    addOutline(shape, face);
    for (const FaceSample& sample : shape.samples)
        shape.bbox_mm.extend(sample.at);
    for (const Vec3& p : shape.outline)
        shape.bbox_mm.extend(p);
    return shape;
}

/// Normal of a face at a parameter of one of its edges.
std::optional<FaceSample> onEdge(const TopoDS_Face& face, const TopoDS_Edge& edge, double parameter) {
    double first = 0;
    double last = 0;
    const Handle(Geom2d_Curve) curve = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (curve.IsNull()) return std::nullopt;
    const gp_Pnt2d uv = curve->Value(parameter);
    return sampleAt(face, BRepAdaptor_Surface(face, Standard_False), uv.X(), uv.Y());
}

/// The edge as the face's boundary uses it, for its direction.
TopoDS_Edge asUsedBy(const TopoDS_Face& face, const TopoDS_Edge& edge) {
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next())
        if (it.Current().IsSame(edge)) return TopoDS::Edge(it.Current());
    return edge;
}

std::optional<FaceEdge> edgeBetween(const TopoDS_Face& a, const TopoDS_Face& b, const TopoDS_Edge& shared,
                                    const Tolerances& tol) {
    const TopoDS_Edge edge = asUsedBy(a, shared);
    const BRepAdaptor_Curve curve(edge);
    const double middle = (curve.FirstParameter() + curve.LastParameter()) / 2;
    const auto on_a = onEdge(a, edge, middle);
    const auto on_b = onEdge(b, edge, middle);
    if (!on_a || !on_b) return std::nullopt;
    gp_Pnt p;
    gp_Vec tangent;
    curve.D1(middle, p, tangent);
    if (edge.Orientation() == TopAbs_REVERSED) tangent.Reverse();
    FaceEdge met;
    const Vec3 turn = on_a->normal.cross(on_b->normal);
    met.turn_rad = std::atan2(turn.norm(), on_a->normal.dot(on_b->normal));
    if (met.turn_rad > tol.angular_rad)
        met.bend = turn.dot(vec(tangent.XYZ())) > 0 ? Bend::Convex : Bend::Concave;
    met.straight = curve.GetType() == GeomAbs_Line;
    met.length_mm = GCPnts_AbscissaPoint::Length(curve);
    met.from = vec(curve.Value(curve.FirstParameter()).XYZ());
    met.to = vec(curve.Value(curve.LastParameter()).XYZ());
    return met;
}

std::vector<FaceEdge> edgesOf(const TopoDS_Shape& solid, const std::vector<TopoDS_Face>& faces,
                              const Tolerances& tol) {
    std::vector<FaceEdge> edges;
    TopTools_IndexedMapOfShape number;
    for (const TopoDS_Face& face : faces)
        number.Add(face);
    TopTools_IndexedDataMapOfShapeListOfShape faces_of_edge;
    TopExp::MapShapesAndAncestors(solid, TopAbs_EDGE, TopAbs_FACE, faces_of_edge);
    for (int i = 1; i <= faces_of_edge.Extent(); ++i) {
        const TopoDS_Edge edge = TopoDS::Edge(faces_of_edge.FindKey(i));
        if (BRep_Tool::Degenerated(edge) || faces_of_edge(i).Extent() != 2) continue;
        const int first = number.FindIndex(faces_of_edge(i).First()) - 1;
        const int second = number.FindIndex(faces_of_edge(i).Last()) - 1;
        if (first == second) continue;
        std::optional<FaceEdge> met = edgeBetween(faces[first], faces[second], edge, tol);
        if (!met) continue;
        met->first = first;
        met->second = second;
        edges.push_back(*met);
    }
    return edges;
}

/// The part's faces in the order of its list.
std::vector<TopoDS_Face> listedFaces(const Part& part) {
    STEPMILL_CHECK(part.shape, "a part to describe has a shape");
    std::vector<TopoDS_Face> faces = facesOf(part.shape->solid);
    STEPMILL_CHECK(faces.size() == part.faces.size(), "a part lists its faces");
    return faces;
}

}  // namespace

FaceGraph faceGraph(const Part& part, const Tolerances& tol) {
    FaceGraph graph;
    guardOcct(ErrorCode::GeometryKernel, "faces of " + part.name, [&] {
        const std::vector<TopoDS_Face> faces = listedFaces(part);
        for (std::size_t i = 0; i < faces.size(); ++i)
            graph.faces.push_back(shapeOf(faces[i], part.faces[i]));
        graph.edges = edgesOf(part.shape->solid, faces, tol);
    });
    return graph;
}

std::vector<FaceEdge> faceEdges(const Part& part, const Tolerances& tol) {
    std::vector<FaceEdge> edges;
    guardOcct(ErrorCode::GeometryKernel, "edges of " + part.name,
              [&] { edges = edgesOf(part.shape->solid, listedFaces(part), tol); });
    return edges;
}

}  // namespace stepmill
