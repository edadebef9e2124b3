// Sections of solids whose facets do not close.

#include "layers/section/hull_section.h"

#include <algorithm>

#include "layers/section/section_trace.h"
#include "layers/section/tidy_loop.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"

namespace stepmill::layers {

namespace {

std::vector<Vec2> pointsOf(const std::vector<Crossing>& chain) {
    std::vector<Vec2> points{chain.front().from};
    for (const Crossing& crossing : chain)
        points.push_back(crossing.to);
    return points;
}

double signedArea(const std::vector<Vec2>& points) {
    double area = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2& a = points[i];
        const Vec2& b = points[(i + 1) % points.size()];
        area += 0.5 * cross(a, b);
    }
    return area;
}

/// Strips along the chain that hold whatever the true walls do between its points.
void addBand(const std::vector<Vec2>& points, double by_mm, std::vector<Region>& out) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        out.push_back(grownHull({points[i], points[i + 1]}, by_mm));
}

/// How far the hull's sides stand from the chain that spans it.
double bulge(const std::vector<Vec2>& hull, const std::vector<Vec2>& points) {
    double most = 0;
    for (std::size_t i = 0; i < hull.size(); ++i) {
        const Vec2 middle = 0.5 * (hull[i] + hull[(i + 1) % hull.size()]);
        double nearest = 1e300;
        for (std::size_t k = 0; k + 1 < points.size(); ++k)
            nearest = std::min(nearest, distanceTo(middle, points[k], Segment{points[k + 1], std::nullopt}));
        most = std::max(most, nearest);
    }
    return most;
}

}  // namespace

std::vector<Vec2> convexHull(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(),
              [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    // Andrew's monotone chains: the lower one from left to right, the upper one back.
    std::vector<Vec2> hull;
    for (int pass = 0; pass < 2; ++pass) {
        const std::size_t begin = hull.size();
        for (const Vec2& p : points) {
            while (hull.size() >= begin + 2 &&
                   cross(hull.back() - hull[hull.size() - 2], p - hull[hull.size() - 2]) <= 0)
                hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::reverse(points.begin(), points.end());
    }
    return hull;
}

Region grownHull(const std::vector<Vec2>& points, double by_mm) {
    if (by_mm <= 0) {
        std::vector<Vec2> snapped;
        for (const Vec2& p : points)
            snapped.push_back(snapToGrid(p));
        const std::vector<Vec2> hull = convexHull(std::move(snapped));
        return hull.size() < 3 ? Region{} : makePolygon(hull);
    }
    // An octagon around the disc of that radius; grid rounding stays inside the disc of two steps more.
    constexpr int kSides = 8;
    const double reach = (by_mm + 2 * kGridMm) / std::cos(kPi / kSides);
    std::vector<Vec2> grown;
    for (const Vec2& p : points)
        for (int k = 0; k < kSides; ++k) {
            const double angle = 2 * kPi * (k + 0.5) / kSides;
            grown.push_back(snapToGrid(Vec2(p + reach * Vec2(std::cos(angle), std::sin(angle)))));
        }
    return makePolygon(convexHull(std::move(grown)));
}

HullSection hullSection(const SolidMesh& mesh, double z_mm, const Tolerances& tol) {
    const Chains chains = traceChains(mesh, z_mm);
    HullSection out;
    out.exceeds_mm = 2 * mesh.chord_mm();
    std::vector<Region> solid;
    std::vector<Region> holes;
    std::vector<Region> bands;
    for (const std::vector<Crossing>& chain : chains.closed) {
        std::vector<Segment> segments;
        for (const Crossing& crossing : chain)
            segments.push_back({snapToGrid(crossing.to), std::nullopt});
        const Loop loop = tidyLoop(std::move(segments));
        if (loop.segments.empty()) continue;
        addBand(pointsOf(chain), mesh.chord_mm(), bands);
        if (stepmill::signedArea(loop) > 0)
            solid.push_back(Region{{loop}});
        else
            holes.push_back(Region{{reversed(loop)}});
    }
    for (const std::vector<Crossing>& chain : chains.open) {
        const std::vector<Vec2> points = pointsOf(chain);
        const std::vector<Vec2> hull = convexHull(points);
        solid.push_back(grownHull(points, mesh.chord_mm()));
        const Vec2 size = boundingBox(solid.back()).sizes();
        // Closed by a straight line it would be a hole: all of it is filled.
        const double exceeds = signedArea(points) < 0 ? 0.5 * size.minCoeff() : bulge(hull, points);
        out.exceeds_mm = std::max(out.exceeds_mm, exceeds + 2 * mesh.chord_mm());
    }
    // A hole is cut from the bodies around it, which are larger, not from those that stand in it.
    std::sort(solid.begin(), solid.end(), [](const Region& a, const Region& b) { return area(a) > area(b); });
    for (const Region& body : solid) {
        Region part = body;
        for (const Region& hole : holes)
            if (area(hole) < area(body)) part = subtract(part, hole, tol);
        out.region = out.region.empty() ? part : unite(out.region, part, tol);
    }
    bands.push_back(out.region);
    out.region = unite(bands, tol);
    return out;
}

}  // namespace stepmill::layers
