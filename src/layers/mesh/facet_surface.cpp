// What surfaces say at the facets that stand for them.

#include "layers/faces/face_surface.h"

namespace stepmill::layers {

namespace {

/// Derivatives whose product is so small beside the square of the longer one meet in a cone's apex or a
/// sphere's pole, where rounding alone would say where the normal points.
constexpr double kSingularShare = 1e-7;

/// Volume between a facet and the surface, from the surface's point over the facet's middle: exact where
/// the gap is a parabola. Facets that lie much farther off than meshing allows tell nothing.
double bumpOf(const MeshFace& face, const MeshTriangle& triangle, const std::vector<Vec3>& nodes) {
    const Vec3& a = nodes[triangle.node[0]];
    const Vec3& b = nodes[triangle.node[1]];
    const Vec3& c = nodes[triangle.node[2]];
    const Vec3 area = 0.5 * (b - a).cross(c - a);
    double u = 0;
    double v = 0;
    for (const gp_Pnt2d& uv : triangle.uv) {
        u += uv.X() / 3;
        v += uv.Y() / 3;
    }
    const gp_Pnt p = face.surface->Value(u, v);
    const double volume = 0.75 * area.dot(Vec3(p.X(), p.Y(), p.Z()) - (a + b + c) / 3);
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    return std::abs(volume) < 0.25 * longest * area.norm() ? volume : 0;
}

}  // namespace

Vec3 normalAt(const MeshFace& face, const gp_Pnt2d& uv) {
    if (face.kind == FaceKind::Plane) return face.normal;
    gp_Pnt p;
    gp_Vec du;
    gp_Vec dv;
    face.surface->D1(uv.X(), uv.Y(), p, du, dv);
    const gp_Vec n = du.Crossed(dv);
    const double length = n.Magnitude();
    const double longer = std::max(du.Magnitude(), dv.Magnitude());
    if (length <= kSingularShare * longer * longer) return Vec3::Zero();
    return (face.reversed ? -1 : 1) / length * Vec3(n.X(), n.Y(), n.Z());
}

void measureFacets(MeshFace& face, const std::vector<int>& facets, const std::vector<Vec3>& nodes,
                   std::vector<MeshTriangle>& triangles, const Tolerances& tol) {
    face.facets_low_mm = 1e300;
    face.facets_high_mm = -1e300;
    face.least_normal_z = 1;
    face.greatest_normal_z = -1;
    std::map<int, double> normal_of_node;
    for (const int t : facets) {
        MeshTriangle& triangle = triangles[t];
        for (int k = 0; k < 3; ++k) {
            const double z = nodes[triangle.node[k]].z();
            face.facets_low_mm = std::min(face.facets_low_mm, z);
            face.facets_high_mm = std::max(face.facets_high_mm, z);
            // A node on a seam has two sets of parameters and one normal.
            const auto [known, is_new] = normal_of_node.try_emplace(triangle.node[k], 0);
            if (is_new) known->second = face.vertical ? 0 : normalAt(face, triangle.uv[k]).z();
            triangle.normal_z[k] = known->second;
            face.least_normal_z = std::min(face.least_normal_z, known->second);
            face.greatest_normal_z = std::max(face.greatest_normal_z, known->second);
        }
        if (face.kind != FaceKind::Plane) triangle.bump_mm3 = bumpOf(face, triangle, nodes);
    }
    if (std::max(std::abs(face.least_normal_z), std::abs(face.greatest_normal_z)) < tol.angular_rad)
        face.vertical = true;
}

}  // namespace stepmill::layers
