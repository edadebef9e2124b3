#pragma once

#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "stepmill/planar/box.h"
#include "stepmill/planar/vector.h"

namespace stepmill {

/// The circle an arc edge lies on, and its sense. Two edges with equal centre and radius lie on the same
/// circle: the value is the name under which walls are shared.
struct Arc {
    Vec2 centre;
    double radius_mm = 0;
    bool ccw = true;

    bool operator==(const Arc&) const = default;
};

/// One edge of a path: from where the previous one ended to `to`, straight or along `arc`.
/// An arc segment that ends where it starts is a full circle.
struct Segment {
    Vec2 to;
    std::optional<Arc> arc;
};

/// A chain of lines and arcs. Closed if it ends where it starts.
struct Path {
    Vec2 start = Vec2::Zero();
    std::vector<Segment> segments;

    const Vec2& end() const { return segments.empty() ? start : segments.back().to; }
    bool closed() const { return !segments.empty() && end() == start; }
};

/// A closed path that bounds a region.
using Loop = Path;

/// A set of points bounded by loops of lines and arcs.
///
/// Outer loops run counter-clockwise, holes clockwise: the region is always on the left. Loops do not
/// cross or touch along an edge; single touching points are allowed. No loop means the empty region.
/// Several outer loops make a region of several components.
struct Region {
    std::vector<Loop> loops;

    bool empty() const { return loops.empty(); }
};

/// Adds a region that lies apart: no loops of the two cross or touch.
void append(Region& region, const Region& apart);

// Construction -------------------------------------------------------------------------------------------

/// Counter-clockwise polygon through `corners`; corners snapped to the grid.
/// \pre at least three corners
Region makePolygon(const std::vector<Vec2>& corners);
Region makeRectangle(const Vec2& min, const Vec2& max);
/// Rectangle with rounded corners; radius 0 gives sharp ones.
/// \pre 2 radius <= the shorter side
Region makeRoundedRectangle(const Vec2& min, const Vec2& max, double radius_mm);
/// One full-circle loop of two half-circle arcs.
Region makeCircle(const Vec2& centre, double radius_mm);

// Measures -----------------------------------------------------------------------------------------------

/// Signed area of a closed path: positive when counter-clockwise. Exact for arcs (shoelace plus circular
/// segments about the first point). [mm2]
double signedArea(const Loop& loop);
/// Area of the region [mm2], from the lines and arcs themselves.
double area(const Region& region);
double length(const Vec2& from, const Segment& segment);
double length(const Path& path);
/// Total length of all boundary loops [mm].
double perimeter(const Region& region);
Box2 boundingBox(const Path& path);
Box2 boundingBox(const Region& region);
/// Area and its moments about the centre of area. Integrals along the lines and arcs about a local origin:
/// exact to about twelve digits of what a region of that size can have, wherever it lies.
struct Moments {
    double area_mm2 = 0;
    Vec2 centroid = Vec2::Zero();
    /// Integrals of x x, x y, y y from the centroid [mm4]: the trace is the polar moment.
    Eigen::Matrix2d second_mm4 = Eigen::Matrix2d::Zero();
};
/// \pre area > 0
Moments moments(const Region& region);
/// Centre of area.
/// \pre area > 0
Vec2 centroid(const Region& region);

/// Angle swept by an arc segment, positive for ccw, in (0, 2 pi] or [-2 pi, 0) [rad].
double sweepAngle(const Vec2& from, const Vec2& to, const Arc& arc);
/// Point at the share t in [0, 1] of the segment's length.
Vec2 pointAt(const Vec2& from, const Segment& segment, double t);
/// Unit direction of travel at the share t in [0, 1] of the segment's length.
Vec2 tangentAt(const Vec2& from, const Segment& segment, double t);
/// Distance from p to the segment [mm].
double distanceTo(const Vec2& p, const Vec2& from, const Segment& segment);
/// Distance from p to the nearest edge of the path [mm]; infinity for a path without edges. O(edges).
double distanceTo(const Vec2& p, const Path& path);

/// Is p inside or on the boundary (within 1 nm)? O(edges).
bool contains(const Region& region, const Vec2& p);
/// Distance from p to the nearest boundary edge [mm]; infinity for the empty region. O(edges).
double distanceToBoundary(const Region& region, const Vec2& p);
/// Distance from p to the region [mm], 0 inside; infinity for the empty region. O(edges).
double distanceToRegion(const Region& region, const Vec2& p);

// Structure ----------------------------------------------------------------------------------------------

/// Connected components, each one outer loop with its holes, ordered by the outer loop's lowest, then
/// leftmost point. The order is a function of the point set alone.
std::vector<Region> components(const Region& region);
/// The region of the outer loops alone, holes filled.
Region withoutHoles(const Region& region);
Path reversed(const Path& path);
Region translated(const Region& region, const Vec2& by);
/// Points along the path no farther apart than chords of the given sagitta ask for; first and last point
/// included, points on the true curve.
std::vector<Vec2> tessellate(const Path& path, double chord_mm);

/// What breaks the rules of a Region, in words with coordinates, or nothing when it is valid. Costly:
/// O(n log n) with a full crossing test.
std::optional<std::string> diagnose(const Region& region);
/// Throws Error(InvalidRegion, subject) if diagnose() finds anything.
void validate(const Region& region, const std::string& subject);

}  // namespace stepmill
