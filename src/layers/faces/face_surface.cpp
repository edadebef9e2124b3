// What is known of a face from its surface type.

#include "layers/faces/face_surface.h"

#include <BRep_Tool.hxx>
#include <Geom_ConicalSurface.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Geom_Line.hxx>
#include <Geom_Plane.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_SurfaceOfLinearExtrusion.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <gp_Cone.hxx>
#include <gp_Pln.hxx>

namespace stepmill::layers {

namespace {

/// Sine of the angle between a direction and the vertical is that small: vertical.
bool isVertical(const gp_Dir& d, const Tolerances& tol) {
    return std::hypot(d.X(), d.Y()) < tol.angular_rad;
}

bool isHorizontal(const gp_Dir& d, const Tolerances& tol) {
    return std::abs(d.Z()) < tol.angular_rad;
}

Vec2 gridPoint(const gp_Pnt& p) {
    return snapToGrid(Vec2(p.X(), p.Y()));
}

void describePlane(const Geom_Plane& plane, const Tolerances& tol, MeshFace& face) {
    face.kind = FaceKind::Plane;
    const gp_Pln pln = plane.Pln();
    gp_Dir n = pln.Axis().Direction();
    if (!pln.Direct()) n.Reverse();
    if (face.reversed) n.Reverse();
    face.normal = Vec3(n.X(), n.Y(), n.Z());
    const gp_Pnt p = pln.Location();
    face.offset_mm = face.normal.dot(Vec3(p.X(), p.Y(), p.Z()));
    face.horizontal = isVertical(n, tol);
    face.vertical = isHorizontal(n, tol);
}

void describeTurned(const gp_Ax3& position, const Tolerances& tol, MeshFace& face) {
    if (!isVertical(position.Direction(), tol)) return;
    face.kind = FaceKind::Turned;
    face.axis = gridPoint(position.Location());
}

}  // namespace

MeshFace describeFace(const TopoDS_Face& topo_face, const Tolerances& tol) {
    MeshFace face;
    face.reversed = topo_face.Orientation() == TopAbs_REVERSED;
    face.surface = BRep_Tool::Surface(topo_face);
    if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(face.surface);
        !trimmed.IsNull())
        face.surface = trimmed->BasisSurface();
    if (const auto plane = Handle(Geom_Plane)::DownCast(face.surface); !plane.IsNull()) {
        describePlane(*plane, tol, face);
    } else if (const auto cyl = Handle(Geom_CylindricalSurface)::DownCast(face.surface); !cyl.IsNull()) {
        describeTurned(cyl->Position(), tol, face);
        face.vertical = face.kind == FaceKind::Turned;
        const gp_Dir axis = cyl->Position().Direction();
        if (isHorizontal(axis, tol)) {
            face.kind = FaceKind::Lying;
            face.axis = Vec2(axis.X(), axis.Y()).normalized();
        }
    } else if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(face.surface); !cone.IsNull()) {
        describeTurned(cone->Position(), tol, face);
    } else if (const auto ball = Handle(Geom_SphericalSurface)::DownCast(face.surface); !ball.IsNull()) {
        face.kind = FaceKind::Turned;
        face.axis = gridPoint(ball->Location());
    } else if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(face.surface); !torus.IsNull()) {
        describeTurned(torus->Position(), tol, face);
    } else if (const auto wall = Handle(Geom_SurfaceOfLinearExtrusion)::DownCast(face.surface);
               !wall.IsNull()) {
        face.vertical = isVertical(wall->Direction(), tol);
    }
    return face;
}

double MeshFace::radiusAt(double z_mm, double hint_mm) const {
    if (const auto cyl = Handle(Geom_CylindricalSurface)::DownCast(surface); !cyl.IsNull())
        return cyl->Radius();
    if (const auto cone = Handle(Geom_ConicalSurface)::DownCast(surface); !cone.IsNull()) {
        const gp_Cone c = cone->Cone();
        const double along = (z_mm - c.Location().Z()) / c.Axis().Direction().Z();
        return std::abs(c.RefRadius() + along * std::tan(c.SemiAngle()));
    }
    if (const auto ball = Handle(Geom_SphericalSurface)::DownCast(surface); !ball.IsNull()) {
        const double dz = z_mm - ball->Location().Z();
        return std::sqrt(std::max(0.0, ball->Radius() * ball->Radius() - dz * dz));
    }
    const auto torus = Handle(Geom_ToroidalSurface)::DownCast(surface);
    const double dz = z_mm - torus->Location().Z();
    const double half = std::sqrt(std::max(0.0, torus->MinorRadius() * torus->MinorRadius() - dz * dz));
    const double outer = torus->MajorRadius() + half;
    const double inner = std::abs(torus->MajorRadius() - half);
    return std::abs(outer - hint_mm) <= std::abs(inner - hint_mm) ? outer : inner;
}

double innerExtreme(const MeshFace& face, double node_z, double edge_z, int direction, double chord_mm) {
    if (direction * (node_z - edge_z) <= 1e-7) return edge_z;
    // The facets' extreme lies within a sagitta of the surface's; where that is known, it is exact.
    std::optional<double> exact;
    if (const auto ball = Handle(Geom_SphericalSurface)::DownCast(face.surface); !ball.IsNull())
        exact = ball->Location().Z() + direction * ball->Radius();
    if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(face.surface); !torus.IsNull())
        exact = torus->Location().Z() + direction * torus->MinorRadius();
    if (const auto cyl = Handle(Geom_CylindricalSurface)::DownCast(face.surface); !cyl.IsNull())
        exact = cyl->Location().Z() + direction * cyl->Radius();
    if (exact && std::abs(*exact - node_z) <= 2 * chord_mm) return *exact;
    return node_z;
}

void widenByCurve(const Geom_Curve& curve, const Vec3& along, double t0, double t1, double& low,
                  double& high) {
    if (curve.IsKind(STANDARD_TYPE(Geom_Line))) return;
    const auto reach = [&](double t) {
        const gp_Pnt p = curve.Value(t);
        return along.dot(Vec3(p.X(), p.Y(), p.Z()));
    };
    const auto slope = [&](double t) {
        const gp_Vec d = curve.DN(t, 1);
        return along.dot(Vec3(d.X(), d.Y(), d.Z()));
    };
    // On a stretch between facet nodes the reach turns at most once: where its slope changes sign.
    double a = t0;
    double b = t1;
    const double slope_a = slope(a);
    if (slope_a * slope(b) >= 0) return;
    for (int i = 0; i < 50; ++i) {
        const double middle = (a + b) / 2;
        (slope_a * slope(middle) > 0 ? a : b) = middle;
    }
    const double extreme = reach((a + b) / 2);
    low = std::min(low, extreme);
    high = std::max(high, extreme);
}

void addSilhouette(const MeshFace& face, std::vector<double>& heights) {
    std::optional<double> z;
    if (const auto ball = Handle(Geom_SphericalSurface)::DownCast(face.surface); !ball.IsNull())
        z = ball->Location().Z();
    if (const auto torus = Handle(Geom_ToroidalSurface)::DownCast(face.surface); !torus.IsNull())
        z = torus->Location().Z();
    if (const auto cyl = Handle(Geom_CylindricalSurface)::DownCast(face.surface);
        !cyl.IsNull() && std::abs(cyl->Position().Direction().Z()) < 1e-6)
        z = cyl->Location().Z();
    if (z && *z > face.z_min_mm && *z < face.z_max_mm) heights.push_back(*z);
}

}  // namespace stepmill::layers
