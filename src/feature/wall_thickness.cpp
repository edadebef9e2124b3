#include "feature/wall_thickness.h"

#include <algorithm>
#include <array>

#include "stepmill/planar/edge.h"

namespace stepmill::feature {
namespace {

/// Rays leave each wall segment at these shares of its length.
constexpr std::array<double, 3> kRayShares{0.1, 0.5, 0.9};
/// Walls up to this much thicker than the thinnest stand with it.
constexpr double kAboutAsThin = 1.5;
/// Sine of the angle between a ray and the other side of a wall, at least.
constexpr double kFacing = 0.95;
/// Walls thicker than this many depths are no walls but the body.
constexpr double kBody = 2;
/// Arcs are measured as chords this near to them, no nearer [mm]: thickness is told to a hundredth.
constexpr double kChordMm = 1e-2;

struct Ray {
    Vec2 from;
    Vec2 direction;  ///< unit, into the material
};

struct Chord {
    Vec2 a;
    Vec2 b;
};

std::vector<Ray> raysOf(const Feature& feature) {
    std::vector<Ray> rays;
    for (const BoundaryPiece& piece : feature.boundary) {
        if (piece.open) continue;
        for (const auto& [from, segment] : eachEdge(piece.path)) {
            for (const double share : kRayShares) {
                const Vec2 along = tangentAt(from, segment, share);
                // The target is on the left, so the material is on the right.
                rays.push_back({pointAt(from, segment, share), {along.y(), -along.x()}});
            }
        }
    }
    return rays;
}

std::vector<Chord> chordsOf(const Region& region, const Box2& near, double chord_mm) {
    std::vector<Chord> chords;
    for (const Loop& loop : region.loops) {
        if (!boundingBox(loop).intersects(near)) continue;
        const std::vector<Vec2> points = tessellate(loop, chord_mm);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            Box2 box;
            box.extend(points[i]);
            box.extend(points[i + 1]);
            if (box.intersects(near)) chords.push_back({points[i], points[i + 1]});
        }
    }
    return chords;
}

/// Way along the ray to the first chord it leaves the material through, or `most`; `most` too where that
/// chord does not face the ray: such a ray cuts off a corner, it does not cross a wall.
double exitDistance(const Ray& ray, const std::vector<Chord>& chords, double least, double most) {
    double nearest = most;
    bool faces = true;
    for (const Chord& chord : chords) {
        const Vec2 edge = chord.b - chord.a;
        const double across = cross(ray.direction, edge);
        // Material is on the chord's left: a ray that leaves it crosses from left to right.
        if (across <= 0) continue;
        const Vec2 to = chord.a - ray.from;
        const double way = cross(to, edge) / across;
        const double share = cross(to, ray.direction) / across;
        if (way <= least || way >= nearest || share < 0 || share > 1) continue;
        nearest = way;
        faces = across >= kFacing * edge.norm();
    }
    return faces ? nearest : most;
}

struct Found {
    double thickness_mm = 0;
    double height_mm = 0;
    Vec2 at;
};

}  // namespace

std::optional<WallThickness> thinnestWall(const Feature& feature, const LayerStack& layers,
                                          const Tolerances& tol) {
    const std::vector<Ray> rays = raysOf(feature);
    const double most = kBody * feature.depth_mm();
    const Box2 near = grown(boundingBox(feature.target), most);
    const double chord_mm = std::max(tol.chord_mm, kChordMm);
    std::vector<Found> found;
    for (const Layer& layer : layers.layers) {
        if (!layer.isWithin(feature.top_z_mm, feature.floor_z_mm)) continue;
        const std::vector<Chord> chords = chordsOf(layer.part, near, chord_mm);
        Found thinnest{most, layer.height_mm(), Vec2::Zero()};
        for (const Ray& ray : rays) {
            // Only where the part, not later stock, is the wall.
            if (!contains(layer.part, ray.from + 2 * tol.sliver_mm * ray.direction)) continue;
            const double way = exitDistance(ray, chords, 2 * chord_mm, thinnest.thickness_mm);
            if (way >= thinnest.thickness_mm) continue;
            thinnest.thickness_mm = way;
            thinnest.at = ray.from;
        }
        if (thinnest.thickness_mm < most) found.push_back(thinnest);
    }
    if (found.empty()) return std::nullopt;
    const auto least = std::min_element(found.begin(), found.end(), [](const Found& a, const Found& b) {
        return a.thickness_mm < b.thickness_mm;
    });
    WallThickness wall{least->thickness_mm, 0, least->at, false};
    for (const Found& layer : found)
        if (layer.thickness_mm <= kAboutAsThin * wall.thickness_mm) wall.height_mm += layer.height_mm;
    wall.thin = wall.thickness_mm < kThinWallMm || wall.height_mm > kSlenderWall * wall.thickness_mm;
    return wall;
}

}  // namespace stepmill::feature
