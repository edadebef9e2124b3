#pragma once

#include <optional>
#include <vector>

#include "stepmill/planar/region.h"

namespace stepmill::toolpath {

/// One line or arc with its start, and the box around it.
struct Edge {
    Vec2 from;
    Segment segment;
    Box2 box;
};

Edge makeEdge(const Vec2& from, const Segment& segment);
std::vector<Edge> edgesOf(const Path& path);
std::vector<Edge> edgesOf(const Region& region);

/// Points that lie on both edges; where edges overlap along a length, none or its ends.
std::vector<Vec2> meetingPoints(const Edge& a, const Edge& b);

/// Least distance between two edges [mm]; exact but for rounding.
double separation(const Edge& a, const Edge& b);

/// Is some edge nearer to `edge` than `distance_mm`?
bool anyNearer(const std::vector<Edge>& edges, const Edge& edge, double distance_mm);

/// Share in [0, 1] of the edge's length at which p, a point on it, lies.
double shareOf(const Edge& edge, const Vec2& p);

/// The part of an edge between two shares of its length, joints on the 1 nm grid. Ends that coincide on
/// the grid give nothing (for an arc they would mean a full circle).
std::optional<Edge> cutOut(const Edge& edge, double from_share, double to_share);

/// Nearest point of a path.
struct NearestPoint {
    double distance_mm = 0;
    std::size_t edge = 0;
    double share = 0;  ///< of that edge's length
    Vec2 point = Vec2::Zero();
};
NearestPoint nearestOn(const Path& path, const Vec2& p);

/// A closed path run through from another of its points.
Path startingAt(const Path& closed, std::size_t edge, double share);

/// The path up to a length from its start, in (0, length].
Path firstPart(const Path& path, double length_mm);

/// Distance from p to the region, 0 inside; infinity for the empty region.
double distanceToRegion(const Region& region, const Vec2& p);

}  // namespace stepmill::toolpath
