// Points of true curves and surfaces at a height.

#include "layers/section/section_points.h"

namespace stepmill::layers {

namespace {

/// Root of a function with a change of sign on [a, b], by regula falsi (Illinois) to 1e-10 mm.
template <typename Height>
double crossingParameter(double a, double b, const Height& height) {
    double fa = height(a);
    double fb = height(b);
    if (fa == 0) return a;
    if (fb == 0) return b;
    if ((fa > 0) == (fb > 0)) return std::abs(fa) < std::abs(fb) ? a : b;
    double t = a;
    for (int i = 0; i < 60; ++i) {
        // Every fourth step halves, so that flat stretches cannot stall the secant.
        t = i % 4 == 3 ? (a + b) / 2 : (a * fb - b * fa) / (fb - fa);
        const double ft = height(t);
        if (std::abs(ft) < 1e-10) break;
        if ((ft > 0) == (fb > 0)) {
            b = t;
            fb = ft;
            fa /= 2;
        } else {
            a = t;
            fa = ft;
            fb /= 2;
        }
    }
    return t;
}

gp_Pnt2d between(const gp_Pnt2d& a, const gp_Pnt2d& b, double s) {
    return gp_Pnt2d(a.X() + s * (b.X() - a.X()), a.Y() + s * (b.Y() - a.Y()));
}

/// Surface parameters where the facet's side crosses the height.
gp_Pnt2d crossingOnSurface(const SolidMesh& mesh, const MeshTriangle& triangle, int side, double z_mm) {
    int k = 0;
    while (triangle.side[k] != side)
        ++k;
    const Geom_Surface& surface = *mesh.faces()[triangle.face].surface;
    const gp_Pnt2d a = triangle.uv[k];
    const gp_Pnt2d b = triangle.uv[(k + 1) % 3];
    const double s = crossingParameter(0, 1, [&](double share) {
        const gp_Pnt2d uv = between(a, b, share);
        return surface.Value(uv.X(), uv.Y()).Z() - z_mm;
    });
    return between(a, b, s);
}

/// Moves surface parameters onto the height, straight up or down the surface's slope.
///
/// Where the surface is nearly level (close to its top) the slope says little: a point that would move
/// farther than `reach_mm` stays, a little off the height but on the surface.
gp_Pnt pullToHeight(const Geom_Surface& surface, gp_Pnt2d uv, double z_mm, double reach_mm) {
    const gp_Pnt start = surface.Value(uv.X(), uv.Y());
    gp_Pnt p = start;
    gp_Vec du;
    gp_Vec dv;
    for (int i = 0; i < 6; ++i) {
        surface.D1(uv.X(), uv.Y(), p, du, dv);
        const double dz = p.Z() - z_mm;
        if (std::abs(dz) < 1e-9) break;
        // Scaled by the lengths of the derivatives: u and v may have quite different units.
        const double gu = du.Z() / std::max(1e-12, du.SquareMagnitude());
        const double gv = dv.Z() / std::max(1e-12, dv.SquareMagnitude());
        const double slope = du.Z() * gu + dv.Z() * gv;
        if (slope < 1e-9) return start;
        uv.SetCoord(uv.X() - dz * gu / slope, uv.Y() - dz * gv / slope);
    }
    return p.Distance(start) <= reach_mm ? p : start;
}

}  // namespace

Vec2 pointOnEdge(const SolidMesh& mesh, int side_index, double z_mm) {
    const MeshSide& side = mesh.sides()[side_index];
    if (side.edge < 0) {
        const Vec3& a = mesh.nodes()[side.a];
        const Vec3& b = mesh.nodes()[side.b];
        const double share = std::clamp((z_mm - a.z()) / (b.z() - a.z()), 0.0, 1.0);
        return (a + share * (b - a)).head<2>();
    }
    const Geom_Curve& curve = *mesh.curve(side.edge);
    const double t =
        crossingParameter(side.t_a, side.t_b, [&](double at) { return curve.Value(at).Z() - z_mm; });
    const gp_Pnt p = curve.Value(t);
    return Vec2(p.X(), p.Y());
}

std::vector<Vec2> pointsOnSurface(const SolidMesh& mesh, const std::vector<Crossing>& crossings,
                                  double z_mm) {
    constexpr int kPiecesPerFacet = 4;
    std::vector<Vec2> points;
    for (const Crossing& crossing : crossings) {
        const MeshTriangle& triangle = mesh.triangles()[crossing.triangle];
        const Geom_Surface& surface = *mesh.faces()[crossing.face].surface;
        const gp_Pnt2d in = crossingOnSurface(mesh, triangle, crossing.side_in, z_mm);
        const gp_Pnt2d out = crossingOnSurface(mesh, triangle, crossing.side_out, z_mm);
        const double facet_length = surface.Value(in.X(), in.Y()).Distance(surface.Value(out.X(), out.Y()));
        for (int i = points.empty() ? 0 : 1; i <= kPiecesPerFacet; ++i) {
            const double share = static_cast<double>(i) / kPiecesPerFacet;
            const gp_Pnt p = pullToHeight(surface, between(in, out, share), z_mm, 0.2 * facet_length);
            const Vec2 point(p.X(), p.Y());
            // Points on top of each other have no direction.
            const bool last = &crossing == &crossings.back() && i == kPiecesPerFacet;
            if (!points.empty() && (point - points.back()).norm() < 1e-5 && !last) continue;
            points.push_back(point);
        }
    }
    return points;
}

}  // namespace stepmill::layers
