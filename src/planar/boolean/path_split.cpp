// Paths cut at a region's boundary, and what follows from it.

#include <algorithm>
#include <cmath>

#include "planar/intersection.h"
#include "planar/segment.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/edge_index.h"
#include "stepmill/planar/path_parts.h"

namespace stepmill {

namespace {

enum class Side { Inside, On, Outside };

struct SidedStretch {
    Side side;
    Path path;
};

/// A region whose boundary many edges are held against.
struct Ground {
    const Region& region;
    EdgeIndex boundary;
};

Side sideOf(const Vec2& from, const Segment& segment, const Ground& ground, double near_mm) {
    Vec2 farthest = from;
    double distance = -1;
    for (const double t : {0.5, 0.25, 0.75}) {
        const Vec2 p = pointAt(from, segment, t);
        const double d = ground.boundary.distanceTo(p);
        if (d <= distance) continue;
        distance = d;
        farthest = p;
    }
    if (distance <= near_mm) return Side::On;
    return planar::windingNumber(ground.region, farthest) > 0 ? Side::Inside : Side::Outside;
}

/// Points of the edge where it meets the boundary, in its direction, without its ends.
std::vector<Vec2> cutsOf(const Edge& edge, const EdgeIndex& boundary, double near_mm) {
    std::vector<std::pair<double, Vec2>> cuts;
    boundary.forEachIn(grown(edge.box, near_mm), [&](const Edge& other) {
        for (const Vec2& p : planar::contacts(edge, other, near_mm))
            cuts.emplace_back(planar::shareOf(p, edge.from, edge.segment), p);
    });
    std::sort(cuts.begin(), cuts.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    const double whole = length(edge);
    std::vector<Vec2> points;
    double last = 0;
    for (const auto& [share, p] : cuts) {
        if ((share - last) * whole <= near_mm || (1 - share) * whole <= near_mm) continue;
        last = share;
        points.push_back(snapToGrid(planar::projectOnCarrier(p, edge.from, edge.segment)));
    }
    return points;
}

void append(std::vector<SidedStretch>& stretches, Side side, const Vec2& from, const Segment& segment,
            bool continues_segment) {
    if (stretches.empty() || stretches.back().side != side) {
        stretches.push_back({side, Path{from, {segment}}});
        return;
    }
    Path& path = stretches.back().path;
    // A touching point does not part a segment.
    if (continues_segment)
        path.segments.back().to = segment.to;
    else
        path.segments.push_back(segment);
}

}  // namespace

SplitPath split(const Path& path, const Region& region, const Tolerances& tol) {
    const Ground ground{region, EdgeIndex(region)};
    std::vector<SidedStretch> stretches;
    for (const Edge& edge : edgesOf(path)) {
        std::vector<Vec2> ends = cutsOf(edge, ground.boundary, tol.linear_mm);
        ends.push_back(edge.segment.to);
        Vec2 begin = edge.from;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const Segment part{ends[i], edge.segment.arc};
            append(stretches, sideOf(begin, part, ground, tol.linear_mm), begin, part, i > 0);
            begin = ends[i];
        }
    }
    // A closed path has no end: its last stretch goes on into the first.
    if (path.closed() && stretches.size() > 1 && stretches.front().side == stretches.back().side) {
        Path joined = std::move(stretches.back().path);
        stretches.pop_back();
        append(joined, stretches.front().path);
        stretches.front().path = std::move(joined);
    }
    SplitPath result;
    for (SidedStretch& stretch : stretches) {
        auto& list = stretch.side == Side::Inside ? result.inside
                     : stretch.side == Side::On   ? result.on
                                                  : result.outside;
        list.push_back(std::move(stretch.path));
    }
    return result;
}

bool covers(const Region& outer, const Region& inner, double slack_mm, const Tolerances& tol) {
    const Region missing = subtract(inner, outer, tol);
    for (const Region& part : components(missing)) {
        const Vec2 size = boundingBox(part).sizes();
        if (std::min(size.x(), size.y()) <= slack_mm) continue;
        // The largest disc in a region is never smaller than area over perimeter.
        if (2 * area(part) > slack_mm * perimeter(part)) return false;
        const auto disc = ClearanceDiagram(part, tol).largestInscribedDisc();
        if (disc && 2 * disc->radius_mm > slack_mm) return false;
    }
    return true;
}

}  // namespace stepmill
