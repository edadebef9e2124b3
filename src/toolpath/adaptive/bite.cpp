#include "toolpath/adaptive/bite.h"

#include <algorithm>
#include <limits>

#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/path_parts.h"
#include "toolpath/patterns/ring_family.h"

namespace stepmill::toolpath {
namespace {

/// Stretches of a front that lie no farther apart than this, in radii, are joined.
constexpr double kJoinedRadii = 2;

/// The length from a path's start to a point on it.
double lengthTo(const NearestPoint& point, const Path& path) {
    const std::vector<Edge> edges = edgesOf(path);
    double length_mm = point.share * length(edges[point.edge]);
    for (std::size_t i = 0; i < point.edge; ++i)
        length_mm += length(edges[i]);
    return length_mm;
}

void lineTo(Path& path, const Vec2& to) {
    if (path.end() != to) path.segments.push_back({to, std::nullopt});
}

}  // namespace

double distanceToStart(const Path& front, const Vec2& at) {
    return front.closed() ? nearestOn(front, at).distance_mm : (front.start - at).norm();
}

Bite biteOf(Region ground, const Region& cleared, const Vec2& at, const Tolerances& tol) {
    Bite bite{std::move(ground), {}, std::numeric_limits<double>::infinity()};
    for (const Loop& loop : bite.ground.loops)
        for (Path& front : split(loop, cleared, tol).outside) {
            if (length(front) <= tol.sliver_mm) continue;
            bite.distance_mm = std::min(bite.distance_mm, distanceToStart(front, at));
            bite.fronts.push_back(std::move(front));
        }
    return bite;
}

std::optional<Region> groundBeside(const Path& way, const Region& cleared, const Region& room,
                                   const Tolerances& tol) {
    for (const Loop& loop : cleared.loops) {
        const NearestPoint from = nearestOn(loop, way.start);
        if (from.distance_mm > onBoundaryMm(tol)) continue;
        const Path turned = startingAt(loop, from.edge, from.share);
        const double length_mm = lengthTo(nearestOn(turned, way.end()), turned);
        if (length_mm <= tol.sliver_mm) return std::nullopt;
        Path around = way;
        const Path back = reversed(firstPart(turned, length_mm));
        lineTo(around, back.start);
        append(around, back);
        lineTo(around, around.start);
        if (signedArea(around) <= 0) return std::nullopt;
        return subtract(intersect(Region{{around}}, room, tol), cleared, tol);
    }
    return std::nullopt;
}

std::vector<Stretch> cuttingStretches(const FrontCut& cut, double radius_mm) {
    std::vector<Stretch> found;
    for (std::size_t i = 0; i < cut.places.size(); ++i) {
        if (cut.places[i].width_mm <= 0) continue;
        const double from_mm = cut.places[i > 0 ? i - 1 : 0].along_mm;
        const double to_mm = cut.places[std::min(i + 1, cut.places.size() - 1)].along_mm;
        if (!found.empty() && from_mm <= found.back().to_mm + kJoinedRadii * radius_mm)
            found.back().to_mm = to_mm;
        else
            found.push_back({from_mm, to_mm});
    }
    return found;
}

}  // namespace stepmill::toolpath
