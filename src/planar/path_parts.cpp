#include "stepmill/planar/path_parts.h"

#include <algorithm>
#include <optional>

#include "stepmill/planar/edge.h"

namespace stepmill {

NearestPoint nearestOn(const Path& path, const Vec2& p) {
    NearestPoint best{(p - path.start).norm(), 0, 0.0, path.start};
    const std::vector<Edge> edges = edgesOf(path);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const double distance_mm = distanceTo(p, edges[i]);
        if (distance_mm >= best.distance_mm) continue;
        const Vec2 on = nearestPoint(edges[i], p);
        best = {distance_mm, i, shareOf(edges[i], on), snapToGrid(on)};
    }
    return best;
}

bool isFullCircle(const Path& closed) {
    const std::vector<Segment>& edges = closed.segments;
    return !edges.empty() && std::all_of(edges.begin(), edges.end(), [&](const Segment& edge) {
        return edge.arc && edge.arc->ccw && edge.arc == edges.front().arc;
    });
}

Path startingAt(const Path& closed, std::size_t edge, double share) {
    const std::vector<Edge> edges = edgesOf(closed);
    const std::optional<Edge> tail = cutOut(edges[edge], share, 1);
    const std::optional<Edge> head = tail ? cutOut(edges[edge], 0, share) : edges[edge];
    Path path{tail ? tail->from : edges[edge].segment.to, {}};
    if (!head) path.start = edges[edge].from;
    if (tail) path.segments.push_back(tail->segment);
    for (std::size_t i = 1; i < edges.size(); ++i)
        path.segments.push_back(edges[(edge + i) % edges.size()].segment);
    if (head) path.segments.push_back(head->segment);
    return path;
}

void append(Path& path, const Path& more) {
    path.segments.insert(path.segments.end(), more.segments.begin(), more.segments.end());
}

Path firstPart(const Path& path, double length_mm) {
    Path part{path.start, {}};
    double left_mm = length_mm;
    for (const Edge& edge : edgesOf(path)) {
        const double whole_mm = length(edge);
        if (whole_mm < left_mm) {
            part.segments.push_back(edge.segment);
            left_mm -= whole_mm;
            continue;
        }
        const std::optional<Edge> last = cutOut(edge, 0, left_mm / whole_mm);
        if (last) part.segments.push_back(last->segment);
        break;
    }
    return part;
}

}  // namespace stepmill
