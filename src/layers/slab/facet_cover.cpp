// Material inside a slab that the sections at its ends do not show.

#include "layers/slab/facet_cover.h"

#include <algorithm>
#include <limits>

#include <Geom_Line.hxx>

#include "layers/indexed_region.h"
#include "layers/section/hull_section.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::layers {

namespace {

Box2 boxOf(const SlabFacet& facet) {
    Box2 box;
    for (int i = 0; i < facet.corners; ++i)
        box.extend(facet.corner[static_cast<std::size_t>(i)]);
    return box;
}

/// Points of the true surface over a facet and of the true edges at its sides, between the heights.
std::vector<Vec2> surfacePoints(const SolidMesh& mesh, const SlabFacet& facet, double top_mm,
                                double bottom_mm) {
    constexpr int kParts = 8;
    const MeshTriangle& triangle = mesh.triangles()[facet.triangle];
    const MeshFace& face = mesh.faces()[facet.face];
    std::vector<Vec2> points;
    const auto add = [&](const gp_Pnt& p) {
        if (p.Z() <= top_mm && p.Z() >= bottom_mm) points.emplace_back(p.X(), p.Y());
    };
    for (int i = 0; i <= kParts; ++i) {
        for (int j = 0; i + j <= kParts; ++j) {
            const double a = static_cast<double>(i) / kParts;
            const double b = static_cast<double>(j) / kParts;
            const double c = 1 - a - b;
            add(face.surface->Value(
                a * triangle.uv[0].X() + b * triangle.uv[1].X() + c * triangle.uv[2].X(),
                a * triangle.uv[0].Y() + b * triangle.uv[1].Y() + c * triangle.uv[2].Y()));
        }
    }
    for (const int s : triangle.side) {
        const MeshSide& side = mesh.sides()[s];
        for (int i = 0; side.edge >= 0 && i <= kParts; ++i)
            add(mesh.curve(side.edge)->Value(side.t_a + (side.t_b - side.t_a) * i / kParts));
    }
    return points;
}

/// Is the facet the surface itself, its sides the edges themselves?
bool isExact(const SolidMesh& mesh, const SlabFacet& facet) {
    if (mesh.faces()[facet.face].kind != FaceKind::Plane) return false;
    const auto& sides = mesh.triangles()[facet.triangle].side;
    return std::all_of(sides.begin(), sides.end(), [&](int s) {
        const int edge = mesh.sides()[s].edge;
        return edge < 0 || mesh.curve(edge)->IsKind(STANDARD_TYPE(Geom_Line));
    });
}

/// Heights of the facets that look down, on a raster over all facets.
class LowestBelow {
  public:
    explicit LowestBelow(const std::vector<SlabFacet>& facets) {
        for (const SlabFacet& facet : facets) {
            const Box2 box = boxOf(facet);
            box_.extend(box);
        }
        low_.assign(static_cast<std::size_t>(kCells) * kCells, 1e300);
        for (const SlabFacet& facet : facets)
            if (facet.normal_z < 0) visit(facet, [&](double& low) { low = std::min(low, facet.low_mm); });
    }
    bool under(const SlabFacet& facet) {
        bool any = false;
        visit(facet, [&](const double& low) { any = any || low < facet.high_mm; });
        return any;
    }

  private:
    static constexpr int kCells = 128;

    int cell(double at, double min, double size) const {
        return size > 0 ? std::clamp(static_cast<int>(kCells * (at - min) / size), 0, kCells - 1) : 0;
    }
    template <typename Visit>
    void visit(const SlabFacet& facet, const Visit& visit_cell) {
        const Box2 box = boxOf(facet);
        const Vec2 size = box_.sizes();
        const int x_end = cell(box.max().x(), box_.min().x(), size.x());
        const int y_end = cell(box.max().y(), box_.min().y(), size.y());
        for (int x = cell(box.min().x(), box_.min().x(), size.x()); x <= x_end; ++x)
            for (int y = cell(box.min().y(), box_.min().y(), size.y()); y <= y_end; ++y)
                visit_cell(low_[static_cast<std::size_t>(x) * kCells + static_cast<std::size_t>(y)]);
    }

    Box2 box_;
    std::vector<double> low_;
};

bool reachesBeyond(const std::vector<Vec2>& points, const IndexedRegion& region, double slack_mm) {
    return std::any_of(points.begin(), points.end(),
                       [&](const Vec2& p) { return region.isBeyond(p, slack_mm); });
}

/// Is the facet with all its surface farther from the region's boundary than its size?
bool deepInside(const SlabFacet& facet, const IndexedRegion& region, double chord_mm) {
    const Box2 box = boxOf(facet);
    const Vec2 middle = 0.5 * (box.min() + box.max());
    return region.isDeep(middle, 0.5 * box.sizes().norm() + chord_mm);
}

/// A region and the index that spares it most booleans.
struct Ground {
    explicit Ground(const Region& of) : region(of), indexed(of) {}

    const Region& region;
    IndexedRegion indexed;
};

/// Corners of a convex polygon, all its sides moved in; empty where nothing surely stays.
std::vector<Vec2> shrunk(const std::vector<Vec2>& corners, double by_mm) {
    std::vector<Vec2> inner;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2& at = corners[i];
        const Vec2 in = (at - corners[(i + corners.size() - 1) % corners.size()]).normalized();
        const Vec2 out = (corners[(i + 1) % corners.size()] - at).normalized();
        const double turn = cross(in, out);
        if (turn < 1e-9) return {};
        // The corner lies where both sides have moved to.
        inner.push_back(at + by_mm / turn * (out - in));
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 side = corners[(i + 1) % corners.size()] - corners[i];
        if (side.dot(inner[(i + 1) % corners.size()] - inner[i]) <= 0) return {};
    }
    return inner;
}

/// Least distance between two parallels that hold the convex polygon [mm].
double widthOf(const std::vector<Vec2>& corners) {
    double width = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 side = (corners[(i + 1) % corners.size()] - corners[i]).normalized();
        double farthest = 0;
        for (const Vec2& p : corners)
            farthest = std::max(farthest, cross(side, p - corners[i]));
        width = std::min(width, farthest);
    }
    return width;
}

/// Does the region's boundary enter the convex polygon?
bool boundaryEnters(const IndexedRegion& region, const std::vector<Vec2>& corners) {
    Box2 box;
    for (const Vec2& corner : corners)
        box.extend(corner);
    std::vector<Edge> sides;
    for (std::size_t i = 0; i < corners.size(); ++i)
        sides.push_back(makeLine(corners[i], corners[(i + 1) % corners.size()]));
    const auto holds = [&](const Vec2& p) {
        return std::all_of(sides.begin(), sides.end(), [&](const Edge& side) {
            return cross(side.to() - side.from, p - side.from) >= 0;
        });
    };
    bool enters = false;
    region.edges().forEachIn(box, [&](const Edge& edge) {
        enters = enters || holds(edge.from) || std::any_of(sides.begin(), sides.end(), [&](const Edge& side) {
                     return separation(side, edge) <= 0;
                 });
    });
    return enters;
}

/// The answer of covers() for a convex polygon. Nothing wider than the slack is missing where the polygon is
/// no wider, or where the region holds all but a strip half as wide along its sides; where a disc wider than
/// it lies beside the region and clear of these sides, that is. A boolean decides between.
bool coversConvex(const Ground& ground, const Region& polygon, double slack_mm, const Tolerances& tol) {
    constexpr double kMoreThanHalf = 0.51;
    if (polygon.empty()) return true;
    std::vector<Vec2> corners;
    for (const Segment& segment : polygon.loops.front().segments)
        corners.push_back(segment.to);
    if (widthOf(corners) <= slack_mm) return true;
    const std::vector<Vec2> held = shrunk(corners, 0.5 * slack_mm);
    if (!held.empty() && !boundaryEnters(ground.indexed, held) && ground.indexed.holds(held.front()))
        return true;
    const std::vector<Vec2> clear = shrunk(corners, kMoreThanHalf * slack_mm);
    for (std::size_t i = 0; i < clear.size(); ++i) {
        const Vec2 middle = 0.5 * (clear[i] + clear[(i + 1) % clear.size()]);
        for (const Vec2& p : {clear[i], middle})
            if (ground.indexed.isBeyond(p, kMoreThanHalf * slack_mm)) return false;
    }
    return covers(ground.region, polygon, slack_mm, tol);
}

}  // namespace

Region facetsBeyond(const SolidMesh& mesh, const std::vector<SlabFacet>& facets, const Region& region,
                    double top_mm, double bottom_mm, const Tolerances& tol) {
    if (facets.empty()) return {};
    const Ground ground(region);
    std::vector<Region> beyond;
    for (const SlabFacet& facet : facets) {
        if (deepInside(facet, ground.indexed, mesh.chord_mm())) continue;
        std::vector<Vec2> points(facet.corner.begin(), facet.corner.begin() + facet.corners);
        if (isExact(mesh, facet)) {
            Region polygon = grownHull(points, 0);
            if (area(polygon) > tol.linear_mm * tol.linear_mm &&
                !coversConvex(ground, polygon, 0.5 * tol.gouge_mm, tol))
                beyond.push_back(std::move(polygon));
            continue;
        }
        const std::vector<Vec2> on_surface = surfacePoints(mesh, facet, top_mm, bottom_mm);
        points.insert(points.end(), on_surface.begin(), on_surface.end());
        // Points may miss what the flat facet shows, and the other way round.
        if (reachesBeyond(on_surface, ground.indexed, 0.5 * tol.gouge_mm) ||
            !coversConvex(ground, grownHull(points, 0), 2 * mesh.chord_mm(), tol))
            beyond.push_back(grownHull(points, mesh.chord_mm()));
    }
    return beyond.empty() ? Region{} : unite(beyond, tol);
}

std::vector<SlabFacet> facetsOverEnds(const std::vector<SlabFacet>& facets) {
    LowestBelow lowest(facets);
    std::vector<SlabFacet> over;
    for (const SlabFacet& facet : facets)
        if (facet.normal_z > 0 && lowest.under(facet)) over.push_back(facet);
    return over;
}

}  // namespace stepmill::layers
