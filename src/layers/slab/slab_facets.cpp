// Facets of a solid between two heights.

#include "layers/slab/slab_facets.h"

#include "layers/clip_polygon.h"

namespace stepmill::layers {

namespace {

struct FacetPoint {
    Vec3 p;
    double normal_z = 0;
};

/// A triangle cut by two planes has at most five corners.
struct Polygon {
    std::array<FacetPoint, 5> at;
    int size = 0;

    void add(const FacetPoint& point) { at[static_cast<std::size_t>(size++)] = point; }
    const FacetPoint& operator[](int i) const { return at[static_cast<std::size_t>(i)]; }
};

/// Keeps what lies above (sign +1) or below (sign -1) the height.
Polygon clip(const Polygon& polygon, double z_mm, int sign) {
    Polygon kept;
    clipPolygon(
        std::span(polygon.at.data(), static_cast<std::size_t>(polygon.size)),
        [&](const FacetPoint& point) { return sign * (point.p.z() - z_mm); },
        [](const FacetPoint& a, const FacetPoint& b, double share) {
            return FacetPoint{a.p + share * (b.p - a.p), a.normal_z + share * (b.normal_z - a.normal_z)};
        },
        [&](const FacetPoint& point) { kept.add(point); });
    return kept;
}

struct Clipped {
    Polygon polygon;  ///< empty where the triangle lies outside
    bool whole = false;
};

Clipped clipped(const SolidMesh& mesh, const MeshTriangle& triangle, double top_mm, double bottom_mm) {
    Clipped out;
    double low = 1e300;
    double high = -1e300;
    for (int k = 0; k < 3; ++k) {
        const Vec3& p = mesh.nodes()[triangle.node[k]];
        low = std::min(low, p.z());
        high = std::max(high, p.z());
        out.polygon.add({p, triangle.normal_z[k]});
    }
    out.whole = low >= bottom_mm && high <= top_mm;
    if (out.whole) return out;
    if (low >= top_mm || high <= bottom_mm) return {};
    out.polygon = clip(clip(out.polygon, top_mm, -1), bottom_mm, 1);
    return out;
}

Vec3 areaVector(const Polygon& polygon) {
    Vec3 area = Vec3::Zero();
    for (int i = 1; i + 1 < polygon.size; ++i)
        area += 0.5 * (polygon[i].p - polygon[0].p).cross(polygon[i + 1].p - polygon[0].p);
    return area;
}

SlabFacet describe(const Polygon& polygon) {
    SlabFacet facet;
    facet.low_mm = facet.high_mm = polygon[0].p.z();
    double moment = 0;
    for (int i = 0; i < polygon.size; ++i) {
        facet.low_mm = std::min(facet.low_mm, polygon[i].p.z());
        facet.high_mm = std::max(facet.high_mm, polygon[i].p.z());
        facet.corner[static_cast<std::size_t>(i)] = polygon[i].p.head<2>();
        facet.normal_z += polygon[i].normal_z / polygon.size;
    }
    facet.corners = polygon.size;
    const Vec3& o = polygon[0].p;
    for (int i = 1; i + 1 < polygon.size; ++i) {
        const Vec3& a = polygon[i].p;
        const Vec3& b = polygon[i + 1].p;
        const double area = 0.5 * ((a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x()));
        facet.plan_area_mm2 += area;
        moment += area * (o.z() + a.z() + b.z()) / 3;
    }
    facet.mean_z_mm = facet.plan_area_mm2 != 0 ? moment / facet.plan_area_mm2 : o.z();
    return facet;
}

bool meets(const MeshFace& face, double top_mm, double bottom_mm) {
    return face.facets_low_mm < top_mm && face.facets_high_mm > bottom_mm;
}

/// Material between facets and curved surfaces in the slab; a cut facet has its share.
double bumps(const SolidMesh& mesh, double top_mm, double bottom_mm) {
    double sum = 0;
    for (std::size_t f = 0; f < mesh.faces().size(); ++f) {
        const MeshFace& face = mesh.faces()[f];
        if (face.kind == FaceKind::Plane || !meets(face, top_mm, bottom_mm)) continue;
        for (const int t : mesh.trianglesOfFace()[f]) {
            const MeshTriangle& triangle = mesh.triangles()[t];
            if (triangle.bump_mm3 == 0) continue;
            const Clipped inside = clipped(mesh, triangle, top_mm, bottom_mm);
            if (inside.whole) {
                sum += triangle.bump_mm3;
            } else if (inside.polygon.size >= 3) {
                const double all = areaVector(clipped(mesh, triangle, 1e300, -1e300).polygon).norm();
                sum += triangle.bump_mm3 * areaVector(inside.polygon).norm() / all;
            }
        }
    }
    return sum;
}

/// Area of the facets' section just below a height. A node at the height counts as above it.
double facetArea(const SolidMesh& mesh, double z_mm) {
    double area = 0;
    for (std::size_t f = 0; f < mesh.faces().size(); ++f) {
        const MeshFace& face = mesh.faces()[f];
        if (face.facets_low_mm >= z_mm || face.facets_high_mm < z_mm) continue;
        for (const int t : mesh.trianglesOfFace()[f]) {
            const MeshTriangle& triangle = mesh.triangles()[t];
            Vec2 in;
            Vec2 out;
            bool crossed = false;
            for (int k = 0; k < 3; ++k) {
                const Vec3& a = mesh.nodes()[triangle.node[k]];
                const Vec3& b = mesh.nodes()[triangle.node[(k + 1) % 3]];
                if ((a.z() >= z_mm) == (b.z() >= z_mm)) continue;
                crossed = true;
                const Vec2 p = (a + (z_mm - a.z()) / (b.z() - a.z()) * (b - a)).head<2>();
                (a.z() >= z_mm ? in : out) = p;
            }
            if (crossed) area += 0.5 * cross(in, out);
        }
    }
    return area;
}

}  // namespace

std::vector<SlabFacet> slopedFacets(const SolidMesh& mesh, double top_mm, double bottom_mm) {
    constexpr double kThinMm = 1e-6;
    std::vector<SlabFacet> out;
    for (std::size_t f = 0; f < mesh.faces().size(); ++f) {
        const MeshFace& face = mesh.faces()[f];
        if (face.vertical || face.horizontal || !meets(face, top_mm, bottom_mm)) continue;
        for (const int t : mesh.trianglesOfFace()[f]) {
            const Polygon polygon = clipped(mesh, mesh.triangles()[t], top_mm, bottom_mm).polygon;
            if (polygon.size < 3) continue;
            SlabFacet facet = describe(polygon);
            if (facet.low_mm >= top_mm) continue;
            facet.face = static_cast<int>(f);
            facet.triangle = t;
            facet.thin = facet.high_mm - facet.low_mm < kThinMm;
            out.push_back(facet);
        }
    }
    return out;
}

double volumeInSlab(const SolidMesh& mesh, const std::vector<SlabFacet>& facets, double top_mm,
                    double bottom_mm) {
    // Flux of (z - bottom) upwards: through the cap at the top, through the leaning facets, and through
    // those horizontal ones that merging of levels has left inside the slab.
    double volume = (top_mm - bottom_mm) * facetArea(mesh, top_mm) + bumps(mesh, top_mm, bottom_mm);
    for (const SlabFacet& facet : facets)
        volume += facet.plan_area_mm2 * (facet.mean_z_mm - bottom_mm);
    for (std::size_t f = 0; f < mesh.faces().size(); ++f) {
        const MeshFace& face = mesh.faces()[f];
        if (!face.horizontal || !meets(face, top_mm, bottom_mm)) continue;
        for (const int t : mesh.trianglesOfFace()[f]) {
            const Polygon polygon = clipped(mesh, mesh.triangles()[t], top_mm, bottom_mm).polygon;
            if (polygon.size < 3) continue;
            const SlabFacet facet = describe(polygon);
            if (facet.low_mm < top_mm) volume += facet.plan_area_mm2 * (facet.mean_z_mm - bottom_mm);
        }
    }
    return volume;
}

void FaceShare::add(const FaceShare& other) {
    up_mm2 += other.up_mm2;
    down_mm2 += other.down_mm2;
    moment_mm3 += other.moment_mm3;
}

double FaceShare::space(double top_mm, double bottom_mm) const {
    // Over what looks up the column to the top; under what looks down the column to the bottom. Where the
    // face looks at itself, as in a hole across the axis, only what it encloses.
    const double to_top = (up_mm2 - down_mm2) * top_mm - moment_mm3;
    return std::max(0.0, to_top + (top_mm - bottom_mm) * std::max(0.0, down_mm2 - up_mm2));
}

std::map<int, FaceShare> sharesOfFaces(const std::vector<SlabFacet>& facets) {
    std::map<int, FaceShare> shares;
    for (const SlabFacet& facet : facets) {
        FaceShare& share = shares[facet.face];
        (facet.plan_area_mm2 > 0 ? share.up_mm2 : share.down_mm2) += std::abs(facet.plan_area_mm2);
        share.moment_mm3 += facet.plan_area_mm2 * facet.mean_z_mm;
    }
    return shares;
}

}  // namespace stepmill::layers
