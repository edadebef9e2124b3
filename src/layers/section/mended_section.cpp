// Sections that always come out.

#include "layers/section/mended_section.h"

#include <fmt/format.h>

#include "layers/section/hull_section.h"
#include "layers/section/section.h"
#include "stepmill/core/error.h"

namespace stepmill::layers {

namespace {

/// The convex hull of all facets in the slab, where not even facets' loops can be united.
HullSection hullOfAll(const SolidMesh& mesh, double top_mm, double bottom_mm) {
    std::vector<Vec2> points;
    for (const MeshTriangle& triangle : mesh.triangles()) {
        const MeshFace& face = mesh.faces()[triangle.face];
        if (face.facets_low_mm >= top_mm || face.facets_high_mm <= bottom_mm) continue;
        for (const int node : triangle.node)
            points.push_back(mesh.nodes()[node].head<2>());
    }
    HullSection out{grownHull(points, mesh.chord_mm()), 0};
    out.exceeds_mm = 0.5 * boundingBox(out.region).sizes().minCoeff();
    return out;
}

HullSection surelyCovering(const SolidMesh& mesh, double z_mm, double top_mm, double bottom_mm,
                           const Tolerances& tol) {
    try {
        HullSection section = hullSection(mesh, z_mm, tol);
        if (!section.region.empty() && !diagnose(section.region)) return section;
    } catch (const Error&) {
        // Loops of facets that cross: the hull of everything is left.
    }
    return hullOfAll(mesh, top_mm, bottom_mm);
}

}  // namespace

MendedSection mendedSection(const SolidMesh& mesh, double z_mm, double top_mm, double bottom_mm,
                            double inset_mm, const Tolerances& tol) {
    const double height = top_mm - bottom_mm;
    // A quarter of a micrometre first: that needs no remark. Then up to a tenth of the slab.
    for (const double by : {0.0, -0.5 * inset_mm, 0.5 * inset_mm, 2e-3, -2e-3, 1e-2, -1e-2, 5e-2, -5e-2,
                            0.01 * height, -0.01 * height, 0.1 * height, -0.1 * height}) {
        const double z = z_mm + by;
        if (z >= top_mm || z <= bottom_mm || std::abs(by) > 0.1 * height) continue;
        std::optional<Region> section = exactSection(mesh, z, tol);
        if (!section) continue;
        MendedSection mended{std::move(*section), z, 0, std::abs(by) > inset_mm, {}};
        if (mended.moved)
            mended.remark =
                fmt::format("section at z {:.4f} mm does not close; taken at z {:.4f} mm", z_mm, z);
        return mended;
    }
    HullSection hull = surelyCovering(mesh, z_mm, top_mm, bottom_mm, tol);
    return {
        std::move(hull.region), z_mm, hull.exceeds_mm, false,
        fmt::format("section at z {:.4f} mm does not close; covered by hulls of its facets, up to {:.3f} mm "
                    "too large",
                    z_mm, hull.exceeds_mm)};
}

}  // namespace stepmill::layers
