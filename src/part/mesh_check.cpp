#include "part/mesh_check.h"

#include <Bnd_Box.hxx>
#include <BRep_Tool.hxx>
#include <BRepAdaptor_Curve.hxx>
#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom_Surface.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <fmt/format.h>

#include "part/measure.h"
#include "part/occt_values.h"
#include "stepmill/part/part_shape.h"

namespace stepmill {
namespace {

/// Coarse: the law the triangles must keep is exact however coarse they are.
constexpr double kChordShare = 1e-3;
constexpr double kAngle_rad = 0.35;

/// What is left of a closed surface by rounding; sound parts stay below 1e-13.
constexpr double kSpreadShare = 1e-9;

/// How far coarse triangles may be from the exact volume: io1-cm-214, the worst of 160 sound parts, 1.1e-3.
constexpr double kVolumeShare = 1e-2;

/// Somewhat too large, at a hundredth of the cost of the tight one.
Box3 roughBox(const TopoDS_Shape& shape) {
    Bnd_Box box;
    BRepBndLib::Add(shape, box, Standard_False);
    Box3 result;
    if (box.IsVoid()) return result;
    const gp_Pnt low = box.CornerMin();
    const gp_Pnt high = box.CornerMax();
    result.extend(Vec3(low.X(), low.Y(), low.Z()));
    result.extend(Vec3(high.X(), high.Y(), high.Z()));
    return result;
}

/// A free-form edge is followed this closely when it is asked whether it crosses itself: a loop is at least
/// as long as a span of its knots.
constexpr int kSegmentsPerSpan = 24;
constexpr int kMostSegments = 4000;

/// Triangles of a shape, gone when this goes.
class Mesh {
  public:
    explicit Mesh(const TopoDS_Shape& shape) : shape_(shape), box_(roughBox(shape)) {
        const double size_mm = box_.sizes().maxCoeff();
        makeFacets(shape, std::max(kChordShare * size_mm, 1e-6), kAngle_rad);
    }
    Mesh(const Mesh&) = delete;
    Mesh& operator=(const Mesh&) = delete;
    ~Mesh() { BRepTools::Clean(shape_); }

    MeshVolume volume() const;
    /// Where an edge crosses itself on a face, if one does.
    std::optional<Vec3> selfCrossing() const;

  private:
    TopoDS_Shape shape_;
    Box3 box_;
};

/// Integrals of x dA_x, y dA_y, z dA_z over a face, about `origin`; nothing without triangles.
std::optional<Vec3> integrate(const TopoDS_Face& face, const Vec3& origin) {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, place);
    if (mesh.IsNull()) return std::nullopt;
    const gp_Trsf to_shape = place.Transformation();
    const auto corner = [&](int node) -> Vec3 {
        return toVec3(mesh->Node(node).Transformed(to_shape)) - origin;
    };
    Vec3 sum = Vec3::Zero();
    for (int i = 1; i <= mesh->NbTriangles(); ++i) {
        int a = 0;
        int b = 0;
        int c = 0;
        mesh->Triangle(i).Get(a, b, c);
        const Vec3 p = corner(a);
        const Vec3 q = corner(b);
        const Vec3 r = corner(c);
        sum += ((q - p).cross(r - p) / 2).cwiseProduct((p + q + r) / 3);
    }
    return face.Orientation() == TopAbs_REVERSED ? Vec3(-sum) : sum;
}

MeshVolume Mesh::volume() const {
    MeshVolume volume;
    const Vec3 origin = box_.center();
    Vec3 sum = Vec3::Zero();
    for (TopExp_Explorer it(shape_, TopAbs_FACE); it.More(); it.Next()) {
        const std::optional<Vec3> part = integrate(TopoDS::Face(it.Current()), origin);
        if (part)
            sum += *part;
        else
            ++volume.bare_faces;
    }
    volume.mean_mm3 = sum.mean();
    volume.spread_mm3 = sum.maxCoeff() - sum.minCoeff();
    return volume;
}

double turn(const gp_Pnt2d& a, const gp_Pnt2d& b, const gp_Pnt2d& c) {
    return gp_Vec2d(a, b).Crossed(gp_Vec2d(a, c));
}

bool cross(const gp_Pnt2d& a, const gp_Pnt2d& b, const gp_Pnt2d& c, const gp_Pnt2d& d) {
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

/// Index of the first segment of a polyline that crosses a later one not beside it.
/// \param closed  the last segment ends where the first one starts: so they lie beside each other
std::optional<std::size_t> crossingOf(const std::vector<gp_Pnt2d>& line, bool closed) {
    // By the left end, so that only segments that overlap in u are compared.
    std::vector<std::size_t> order(line.size() < 2 ? 0 : line.size() - 1);
    for (std::size_t i = 0; i < order.size(); ++i)
        order[i] = i;
    const auto left = [&](std::size_t i) { return std::min(line[i].X(), line[i + 1].X()); };
    const auto right = [&](std::size_t i) { return std::max(line[i].X(), line[i + 1].X()); };
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return left(a) != left(b) ? left(a) < left(b) : a < b; });
    for (std::size_t k = 0; k < order.size(); ++k) {
        const std::size_t a = order[k];
        for (std::size_t m = k + 1; m < order.size() && left(order[m]) <= right(a); ++m) {
            const std::size_t b = order[m];
            const bool at_seam = closed && std::min(a, b) == 0 && std::max(a, b) + 1 == order.size();
            const bool beside = a + 1 == b || b + 1 == a || at_seam;
            if (!beside && cross(line[a], line[a + 1], line[b], line[b + 1])) return a;
        }
    }
    return std::nullopt;
}

std::optional<Vec3> crossingOn(const TopoDS_Edge& edge, const TopoDS_Face& face) {
    double first = 0;
    double last = 0;
    const Handle(Geom2d_Curve) on_surface = BRep_Tool::CurveOnSurface(edge, face, first, last);
    if (on_surface.IsNull()) return std::nullopt;
    const int spans = BRepAdaptor_Curve(edge).NbIntervals(GeomAbs_CN);
    const int segments = std::min(kSegmentsPerSpan * spans, kMostSegments);
    std::vector<gp_Pnt2d> line;
    for (int i = 0; i <= segments; ++i)
        line.push_back(on_surface->Value(first + (last - first) * i / segments));
    const std::optional<std::size_t> at = crossingOf(line, BRep_Tool::IsClosed(edge));
    if (!at) return std::nullopt;
    return toVec3(BRep_Tool::Surface(face)->Value(line[*at].X(), line[*at].Y()));
}

std::optional<Vec3> Mesh::selfCrossing() const {
    for (TopExp_Explorer faces(shape_, TopAbs_FACE); faces.More(); faces.Next())
        for (TopExp_Explorer edges(faces.Current(), TopAbs_EDGE); edges.More(); edges.Next()) {
            const TopoDS_Edge edge = TopoDS::Edge(edges.Current());
            if (!isFreeForm(edge)) continue;
            if (std::optional<Vec3> where = crossingOn(edge, TopoDS::Face(faces.Current()))) return where;
        }
    return std::nullopt;
}

}  // namespace

MeshVolume meshVolume(const TopoDS_Shape& solid) {
    return Mesh(solid).volume();
}

void requireMesh(const TopoDS_Shape& solid, double exact_mm3, const std::string& subject) {
    const Mesh mesh(solid);
    const MeshVolume volume = mesh.volume();
    const auto refuse = [&](const std::string& why) { throw Error(ErrorCode::InvalidSolid, subject, why); };
    if (volume.bare_faces > 0)
        refuse(fmt::format("{} faces have outlines that bound no area", volume.bare_faces));
    if (!(volume.spread_mm3 <= kSpreadShare * std::abs(volume.mean_mm3)))
        refuse(fmt::format(
            "the faces do not all look outwards: the volumes they bound along x, y and z differ by "
            "{:.3g} of {:.6g} mm3",
            volume.spread_mm3, exact_mm3));
    if (const std::optional<Vec3> where = mesh.selfCrossing())
        refuse(fmt::format("an edge crosses itself near ({:.3f}, {:.3f}, {:.3f})", where->x(), where->y(),
                           where->z()));
    if (!(std::abs(volume.mean_mm3 - exact_mm3) <= kVolumeShare * exact_mm3))
        refuse(fmt::format("the outlines of faces cross: triangles bound {:.6g} mm3, the faces {:.6g} mm3",
                           volume.mean_mm3, exact_mm3));
}

}  // namespace stepmill
