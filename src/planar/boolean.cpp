// Unions, intersections and differences of regions.

#include "stepmill/planar/boolean.h"

#include <algorithm>
#include <functional>
#include <optional>

#include "planar/arrangement.h"
#include "planar/loop_builder.h"
#include "stepmill/core/error.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill {

namespace {

using Rule = std::function<bool(int, int)>;

/// Points `inside` the rule, from all boundaries cut at each other.
Region overlay(const std::vector<planar::Curve>& curves, const Rule& inside, const Tolerances& tol) {
    // Where several points crowd within the snapping distance, pieces may be pushed across nodes. Another
    // distance puts the points in other clusters; the first that contradicts itself nowhere is taken.
    std::optional<Region> fallback;
    for (const double factor : {1.0, 0.3, 0.05, 2.5, 0.02, 6.0}) {
        const planar::Arrangement arrangement(curves, factor * tol.linear_mm);
        const std::vector<planar::LabelledPiece> labels = arrangement.labelled();
        const bool consistent = arrangement.consistent(labels);
        if (!consistent && fallback) continue;
        auto region =
            planar::buildLoops(arrangement, planar::Arrangement::boundary(labels, inside), tol.linear_mm);
        if (consistent && region) return *region;
        if (region) fallback = std::move(region);
    }
    if (fallback) return *fallback;
    throw Error(ErrorCode::GeometryKernel, "planar boolean", "the pieces of the result do not close up");
}

/// The loops whose boxes come near the box; outer loops beyond it and their holes cannot hold a point of it.
Region near(const Region& region, const Box2& box) {
    Region result;
    for (const Loop& loop : region.loops)
        if (boundingBox(loop).overlaps(box)) result.loops.push_back(loop);
    return result;
}

std::vector<planar::Curve> curvesOf(const Region& a, const Region& b) {
    std::vector<planar::Curve> curves;
    planar::appendCurves(a, 0, curves);
    planar::appendCurves(b, 1, curves);
    return curves;
}

}  // namespace

Region unite(const Region& a, const Region& b, const Tolerances& tol) {
    const Region both[] = {a, b};
    return unite(both, tol);
}

Region unite(std::span<const Region> regions, const Tolerances& tol) {
    // Many regions on top of each other cross far more often than their union does: halves first.
    constexpr std::size_t kAtOnce = 8;
    if (regions.size() > kAtOnce) {
        const std::size_t half = regions.size() / 2;
        return unite(unite(regions.first(half), tol), unite(regions.subspan(half), tol), tol);
    }
    std::vector<Box2> boxes;
    for (const Region& region : regions)
        boxes.push_back(boundingBox(region).grown(tol.linear_mm));
    std::vector<planar::Curve> curves;
    Region apart;
    for (std::size_t i = 0; i < regions.size(); ++i) {
        bool meets = false;
        for (std::size_t j = 0; j < regions.size() && !meets; ++j)
            meets = i != j && !boxes[i].empty() && !boxes[j].empty() && boxes[i].overlaps(boxes[j]);
        if (meets)
            planar::appendCurves(regions[i], 0, curves);
        else
            apart.loops.insert(apart.loops.end(), regions[i].loops.begin(), regions[i].loops.end());
    }
    if (!curves.empty()) {
        const Region joined = overlay(
            curves, [](int a, int) { return a > 0; }, tol);
        apart.loops.insert(apart.loops.end(), joined.loops.begin(), joined.loops.end());
    }
    return planar::ordered(std::move(apart));
}

Region intersect(const Region& a, const Region& b, const Tolerances& tol) {
    if (a.empty() || b.empty()) return {};
    const Region near_a = near(a, boundingBox(b).grown(tol.linear_mm));
    const Region near_b = near(b, boundingBox(a).grown(tol.linear_mm));
    if (near_a.empty() || near_b.empty()) return {};
    return overlay(
        curvesOf(near_a, near_b), [](int in_a, int in_b) { return in_a > 0 && in_b > 0; }, tol);
}

Region subtract(const Region& a, const Region& b, const Tolerances& tol) {
    if (a.empty()) return {};
    const Region near_b = near(b, boundingBox(a).grown(tol.linear_mm));
    if (near_b.empty()) return planar::ordered(a);
    return overlay(
        curvesOf(a, near_b), [](int in_a, int in_b) { return in_a > 0 && in_b <= 0; }, tol);
}

}  // namespace stepmill
