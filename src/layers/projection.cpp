// Facets of leaning walls, seen from above.

#include "layers/projection.h"

#include "stepmill/planar/boolean.h"

namespace stepmill::layers {

namespace {

struct FacetPoint {
    Vec3 p;
    gp_Pnt2d uv;
};

/// Keeps what lies above (sign +1) or below (sign -1) the height.
std::vector<FacetPoint> clip(const std::vector<FacetPoint>& polygon, double z_mm, int sign) {
    std::vector<FacetPoint> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const FacetPoint& a = polygon[i];
        const FacetPoint& b = polygon[(i + 1) % polygon.size()];
        const double da = sign * (a.p.z() - z_mm);
        const double db = sign * (b.p.z() - z_mm);
        if (da >= 0) kept.push_back(a);
        if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
            const double s = da / (da - db);
            kept.push_back({a.p + s * (b.p - a.p), gp_Pnt2d(a.uv.X() + s * (b.uv.X() - a.uv.X()),
                                                            a.uv.Y() + s * (b.uv.Y() - a.uv.Y()))});
        }
    }
    return kept;
}

double outwardNormalZ(const MeshFace& face, const std::vector<FacetPoint>& polygon) {
    if (face.kind == FaceKind::Plane) return face.normal.z();
    double u = 0;
    double v = 0;
    for (const FacetPoint& point : polygon) {
        u += point.uv.X() / static_cast<double>(polygon.size());
        v += point.uv.Y() / static_cast<double>(polygon.size());
    }
    gp_Pnt p;
    gp_Vec du;
    gp_Vec dv;
    face.surface->D1(u, v, p, du, dv);
    const gp_Vec normal = du.Crossed(dv);
    if (normal.SquareMagnitude() < 1e-30) return 0;
    return (face.reversed ? -1 : 1) * normal.Z() / normal.Magnitude();
}

bool reachesBeyond(const ProjectedFacet& facet, const Region& region, double slack_mm) {
    Vec2 middle = Vec2::Zero();
    for (const Vec2& corner : facet.corners)
        middle += corner / static_cast<double>(facet.corners.size());
    std::vector<Vec2> probes = facet.corners;
    probes.push_back(middle);
    return std::any_of(probes.begin(), probes.end(), [&](const Vec2& p) {
        return !contains(region, p) && distanceToBoundary(region, p) > slack_mm;
    });
}

}  // namespace

std::vector<ProjectedFacet> slopedFacets(const SolidMesh& mesh, double top_mm, double bottom_mm) {
    std::vector<ProjectedFacet> out;
    for (std::size_t f = 0; f < mesh.faces().size(); ++f) {
        const MeshFace& face = mesh.faces()[f];
        if (face.vertical || face.horizontal || face.z_min_mm >= top_mm || face.z_max_mm <= bottom_mm)
            continue;
        for (const int t : mesh.trianglesOfFace()[f]) {
            const MeshTriangle& triangle = mesh.triangles()[t];
            std::vector<FacetPoint> polygon;
            for (int k = 0; k < 3; ++k)
                polygon.push_back({mesh.nodes()[triangle.node[k]], triangle.uv[k]});
            polygon = clip(clip(polygon, top_mm, -1), bottom_mm, 1);
            if (polygon.size() < 3) continue;
            ProjectedFacet facet;
            double low = 1e300;
            double high = -1e300;
            for (const FacetPoint& point : polygon) {
                facet.corners.push_back(point.p.head<2>());
                low = std::min(low, point.p.z());
                high = std::max(high, point.p.z());
            }
            // What merging of levels leaves of a face beyond its end.
            if (high - low < 1e-6) continue;
            facet.normal_z = outwardNormalZ(face, polygon);
            out.push_back(std::move(facet));
        }
    }
    return out;
}

Region facetsBeyond(const std::vector<ProjectedFacet>& facets, const Region& region, double slack_mm,
                    const Tolerances& tol) {
    std::vector<Region> beyond;
    for (const ProjectedFacet& facet : facets) {
        if (facet.normal_z <= 0 || !reachesBeyond(facet, region, slack_mm)) continue;
        Region polygon = makePolygon(facet.corners);
        if (area(polygon) > tol.linear_mm * tol.linear_mm) beyond.push_back(std::move(polygon));
    }
    return beyond.empty() ? Region{} : unite(beyond, tol);
}

}  // namespace stepmill::layers
