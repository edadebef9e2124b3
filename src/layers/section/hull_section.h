#pragma once

#include <vector>

#include "layers/mesh/solid_mesh.h"
#include "stepmill/planar/region.h"

namespace stepmill::layers {

/// Corners of the convex hull, counter-clockwise; fewer than three when the points lie on one line.
std::vector<Vec2> convexHull(std::vector<Vec2> points);

/// Convex hull of discs of that radius about the points, as a polygon around it; of the points alone for
/// radius 0, empty if they lie on one line.
Region grownHull(const std::vector<Vec2>& points, double by_mm);

/// A region that surely holds the solid's section at one height.
struct HullSection {
    Region region;
    /// How far it may reach beyond the true section [mm].
    double exceeds_mm = 0;
};

/// The last resort where facets leave gaps or exact loops cross: closed chains of facets as polygons grown
/// by the sagitta, open ones as the convex hull of what there is of them. The hull of a hole fills it.
HullSection hullSection(const SolidMesh& mesh, double z_mm, const Tolerances& tol);

}  // namespace stepmill::layers
