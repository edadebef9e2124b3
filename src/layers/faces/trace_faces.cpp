// The part's faces as a setup sees them.

#include "layers/faces/trace_faces.h"

#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Plane.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>

#include "layers/faces/face_outline.h"
#include "layers/faces/face_surface.h"
#include "stepmill/core/parallel.h"

namespace stepmill::layers {

namespace {

/// Normals that turn less than that above or below the horizontal are rounding.
constexpr double kLevelNormal = 1e-6;

FaceStand standOf(const MeshFace& face) {
    if (face.horizontal) return face.normal.z() > 0 ? FaceStand::Floor : FaceStand::Ceiling;
    if (face.vertical) return FaceStand::Wall;
    if (face.least_normal_z >= -kLevelNormal) return FaceStand::Leaning;
    return face.greatest_normal_z <= kLevelNormal ? FaceStand::Overhang : FaceStand::Turning;
}

/// Does the outward normal point at the point?
bool looksAt(const Vec3& normal, const Vec3& from, const gp_Pnt& to) {
    return normal.dot(Vec3(to.X(), to.Y(), to.Z()) - from) > 0;
}

void describeRound(const MeshFace& face, const Vec3& normal, const Vec3& at, FaceTrace& trace) {
    const auto centreOn = [&](const gp_Pnt& p) { trace.axis_point = snapToGrid(Vec2(p.X(), p.Y())); };
    // A point of the axis beside the place looked at.
    const auto beside = [&](const gp_Ax1& axis) {
        const gp_Vec to(axis.Location(), gp_Pnt(at.x(), at.y(), at.z()));
        return axis.Location().Translated(gp_Vec(axis.Direction()) * to.Dot(gp_Vec(axis.Direction())));
    };
    if (const auto cylinder = Handle(Geom_CylindricalSurface)::DownCast(face.surface); !cylinder.IsNull()) {
        trace.surface = SurfaceKind::Cylinder;
        trace.radius_mm = cylinder->Radius();
        trace.hollow = looksAt(normal, at, beside(cylinder->Axis()));
        if (face.kind == FaceKind::Turned) centreOn(cylinder->Location());
    } else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(face.surface); !cone.IsNull()) {
        trace.surface = SurfaceKind::Cone;
        trace.hollow = looksAt(normal, at, beside(cone->Axis()));
        if (face.kind == FaceKind::Turned) {
            centreOn(cone->Location());
            trace.radius_mm = std::max(face.radiusAt(face.z_min_mm, 0), face.radiusAt(face.z_max_mm, 0));
        }
    } else if (const auto ball = Handle(Geom_SphericalSurface)::DownCast(face.surface); !ball.IsNull()) {
        trace.surface = SurfaceKind::Sphere;
        trace.radius_mm = ball->Radius();
        trace.hollow = looksAt(normal, at, ball->Location());
        centreOn(ball->Location());
    } else if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(face.surface); !torus.IsNull()) {
        trace.surface = SurfaceKind::Torus;
        trace.radius_mm = torus->MinorRadius();
        const gp_Pnt on_axis = beside(torus->Axis());
        const gp_Vec out(on_axis, gp_Pnt(at.x(), at.y(), at.z()));
        const gp_Vec level = out.Magnitude() > 0 ? out.Normalized() * torus->MajorRadius() : out;
        const gp_Pnt tube(torus->Location().Translated(level));
        trace.hollow = looksAt(normal, at, tube);
        if (face.kind == FaceKind::Turned) centreOn(torus->Location());
    }
}

FaceTrace traceFace(const SolidMesh& mesh, int index, const Tolerances& tol) {
    const MeshFace& face = mesh.faces()[index];
    FaceTrace trace;
    trace.face = index;
    trace.stand = standOf(face);
    trace.top_z_mm = face.z_max_mm;
    trace.bottom_z_mm = face.z_min_mm;
    if (face.horizontal) trace.top_z_mm = trace.bottom_z_mm = face.offset_mm * (face.normal.z() > 0 ? 1 : -1);
    trace.least_normal_z = face.least_normal_z;
    trace.greatest_normal_z = face.greatest_normal_z;
    if (face.kind == FaceKind::Plane) {
        trace.surface = SurfaceKind::Plane;
    } else {
        const MeshTriangle& some = mesh.triangles()[mesh.trianglesOfFace()[index].front()];
        const gp_Pnt2d middle((some.uv[0].X() + some.uv[1].X() + some.uv[2].X()) / 3,
                              (some.uv[0].Y() + some.uv[1].Y() + some.uv[2].Y()) / 3);
        const gp_Pnt at = face.surface->Value(middle.X(), middle.Y());
        describeRound(face, normalAt(face, middle), Vec3(at.X(), at.Y(), at.Z()), trace);
    }
    if (trace.stand == FaceStand::Wall)
        trace.footprint = footprintOf(mesh, index, tol);
    else if (trace.stand != FaceStand::Turning)
        trace.region = outlineFromAbove(mesh, index, tol);
    return trace;
}

}  // namespace

std::vector<FaceTrace> traceFaces(const SolidMesh& mesh, const std::vector<FaceEdge>& edges,
                                  const Tolerances& tol) {
    std::vector<FaceTrace> traces(mesh.faces().size());
    parallelFor(traces.size(), [&](std::size_t i) { traces[i] = traceFace(mesh, static_cast<int>(i), tol); });
    std::vector<std::vector<FaceNeighbour>> neighbours = neighboursOf(edges, traces.size());
    for (std::size_t i = 0; i < traces.size(); ++i)
        traces[i].neighbours = std::move(neighbours[i]);
    nameCauses(mesh, traces);
    return traces;
}

}  // namespace stepmill::layers
