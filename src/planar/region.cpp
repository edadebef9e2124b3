// Regions and their measures, from the lines and arcs themselves.

#include "stepmill/planar/region.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "planar/components.h"
#include "planar/segment.h"
#include "stepmill/core/error.h"
#include "stepmill/core/tolerances.h"
#include "stepmill/core/units.h"

namespace stepmill {

void append(Region& region, const Region& apart) {
    region.loops.insert(region.loops.end(), apart.loops.begin(), apart.loops.end());
}

// Construction -------------------------------------------------------------------------------------------

Region makePolygon(const std::vector<Vec2>& corners) {
    STEPMILL_CHECK(corners.size() >= 3, "a polygon has at least three corners");
    Loop loop{snapToGrid(corners.front()), {}};
    for (std::size_t i = 1; i <= corners.size(); ++i)
        loop.segments.push_back({snapToGrid(corners[i % corners.size()]), std::nullopt});
    return {{signedArea(loop) < 0 ? reversed(loop) : loop}};
}

Region makeRectangle(const Vec2& min, const Vec2& max) {
    return makePolygon({min, {max.x(), min.y()}, max, {min.x(), max.y()}});
}

Region makeRoundedRectangle(const Vec2& min, const Vec2& max, double radius_mm) {
    const double r = snapToGrid(radius_mm);
    if (r <= 0) return makeRectangle(min, max);
    const Vec2 lo = snapToGrid(min);
    const Vec2 hi = snapToGrid(max);
    STEPMILL_CHECK(2 * r <= std::min(hi.x() - lo.x(), hi.y() - lo.y()) + kGridMm,
                   "corner radius is more than half of the shorter side");
    // Corner i has its centre inside the rectangle; the arc turns from direction -90 degrees + 90 i.
    const Vec2 centres[4] = {{hi.x() - r, lo.y() + r},
                             {hi.x() - r, hi.y() - r},
                             {lo.x() + r, hi.y() - r},
                             {lo.x() + r, lo.y() + r}};
    const Vec2 directions[5] = {{0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    Loop loop{snapToGrid(Vec2(centres[3] + r * directions[4])), {}};
    for (int i = 0; i < 4; ++i) {
        const Vec2 centre = snapToGrid(centres[i]);
        const Vec2 arc_start = snapToGrid(Vec2(centre + r * directions[i]));
        const Vec2 arc_end = snapToGrid(Vec2(centre + r * directions[i + 1]));
        // A side that the radii leave no length of is left out.
        if ((arc_start - loop.end()).norm() > 0.5 * kGridMm) loop.segments.push_back({arc_start, {}});
        loop.segments.push_back({arc_end, Arc{centre, r, true}});
    }
    loop.segments.back().to = loop.start;
    return {{loop}};
}

Region makeCircle(const Vec2& centre, double radius_mm) {
    const Vec2 c = snapToGrid(centre);
    const double r = snapToGrid(radius_mm);
    STEPMILL_CHECK(r > 0, "a circle has a positive radius");
    const Vec2 right = snapToGrid(Vec2(c.x() + r, c.y()));
    const Vec2 left = snapToGrid(Vec2(c.x() - r, c.y()));
    const Arc arc{c, r, true};
    return {{Loop{left, {{right, arc}, {left, arc}}}}};
}

// Measures -----------------------------------------------------------------------------------------------

namespace {

/// theta - sin(theta), without cancellation for small angles.
double angleMinusSine(double theta) {
    if (std::abs(theta) > 0.1) return theta - std::sin(theta);
    const double s = theta * theta;
    return theta * s / 6 * (1 - s / 20 * (1 - s / 42 * (1 - s / 72)));
}

/// Calls visit(from, segment) for every edge of the path.
template <typename Visit>
void forEachSegment(const Path& path, Visit visit) {
    const Vec2* from = &path.start;
    for (const Segment& segment : path.segments) {
        visit(*from, segment);
        from = &segment.to;
    }
}

template <typename Visit>
void forEachSegment(const Region& region, Visit visit) {
    for (const Loop& loop : region.loops)
        forEachSegment(loop, visit);
}

/// Compass points of the circle that lie on the arc.
template <typename Visit>
void forEachExtreme(const Vec2& from, const Vec2& to, const Arc& arc, Visit visit) {
    const Vec2 directions[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (const Vec2& direction : directions) {
        const Vec2 p = arc.centre + arc.radius_mm * direction;
        if (planar::inSweep(from, to, arc, p)) visit(p);
    }
}

}  // namespace

double signedArea(const Loop& loop) {
    double twice = 0;
    forEachSegment(loop, [&](const Vec2& from, const Segment& segment) {
        twice += cross(from - loop.start, segment.to - loop.start);
        if (!segment.arc) return;
        const double r = segment.arc->radius_mm;
        twice += r * r * angleMinusSine(sweepAngle(from, segment.to, *segment.arc));
    });
    return twice / 2;
}

double area(const Region& region) {
    double sum = 0;
    for (const Loop& loop : region.loops)
        sum += signedArea(loop);
    return sum;
}

double perimeter(const Region& region) {
    double sum = 0;
    for (const Loop& loop : region.loops)
        sum += length(loop);
    return sum;
}

Box2 planar::boundingBox(const Vec2& from, const Segment& segment) {
    Box2 box(from);
    box.extend(segment.to);
    if (segment.arc) forEachExtreme(from, segment.to, *segment.arc, [&](const Vec2& p) { box.extend(p); });
    return box;
}

Box2 boundingBox(const Path& path) {
    Box2 box(path.start);
    forEachSegment(path, [&](const Vec2& from, const Segment& segment) {
        box.extend(planar::boundingBox(from, segment));
    });
    return box;
}

Box2 boundingBox(const Region& region) {
    Box2 box;
    for (const Loop& loop : region.loops) {
        const Box2 part = boundingBox(loop);
        box.extend(part);
    }
    return box;
}

namespace planar {

int windingNumber(const Loop& loop, const Vec2& p) {
    int winding = 0;
    forEachSegment(
        loop, [&](const Vec2& from, const Segment& segment) { winding += windingShare(from, segment, p); });
    return winding;
}

int windingNumber(const Region& region, const Vec2& p) {
    int winding = 0;
    for (const Loop& loop : region.loops)
        winding += windingNumber(loop, p);
    return winding;
}

Vec2 lowestPoint(const Path& path) {
    Vec2 lowest = path.start;
    const auto offer = [&](const Vec2& p) {
        if (p.y() < lowest.y() || (p.y() == lowest.y() && p.x() < lowest.x())) lowest = p;
    };
    forEachSegment(path, [&](const Vec2& from, const Segment& segment) {
        offer(segment.to);
        if (segment.arc) forEachExtreme(from, segment.to, *segment.arc, offer);
    });
    return lowest;
}

Vec2 pointAwayFrom(const Loop& loop, const Loop& other) {
    Vec2 best = loop.start;
    double best_distance = -1;
    forEachSegment(loop, [&](const Vec2& from, const Segment& segment) {
        const Vec2 middle = pointAt(from, segment, 0.5);
        double distance = std::numeric_limits<double>::infinity();
        forEachSegment(other, [&](const Vec2& other_from, const Segment& other_segment) {
            distance = std::min(distance, distanceTo(middle, other_from, other_segment));
        });
        if (distance > best_distance) {
            best = middle;
            best_distance = distance;
        }
    });
    return best;
}

}  // namespace planar

namespace {

/// Does p lie on the edge, within 1 nm? A look at a line's box spares most distances.
bool liesOn(const Vec2& p, const Vec2& from, const Segment& segment) {
    if (!segment.arc && !grown(planar::boundingBox(from, segment), 2 * kGridMm).contains(p)) return false;
    return distanceTo(p, from, segment) <= kGridMm;
}

}  // namespace

bool contains(const Region& region, const Vec2& p) {
    if (planar::windingNumber(region, p) > 0) return true;
    bool on_boundary = false;
    forEachSegment(region, [&](const Vec2& from, const Segment& segment) {
        on_boundary = on_boundary || liesOn(p, from, segment);
    });
    return on_boundary;
}

double distanceToBoundary(const Region& region, const Vec2& p) {
    double distance = std::numeric_limits<double>::infinity();
    forEachSegment(region, [&](const Vec2& from, const Segment& segment) {
        distance = std::min(distance, distanceTo(p, from, segment));
    });
    return distance;
}

double distanceToRegion(const Region& region, const Vec2& p) {
    return contains(region, p) ? 0.0 : distanceToBoundary(region, p);
}

// Structure ----------------------------------------------------------------------------------------------

namespace {

bool lowerLeft(const Loop& a, const Loop& b) {
    const Vec2 p = planar::lowestPoint(a);
    const Vec2 q = planar::lowestPoint(b);
    if (p.y() != q.y()) return p.y() < q.y();
    if (p.x() != q.x()) return p.x() < q.x();
    return std::abs(signedArea(a)) < std::abs(signedArea(b));
}

/// A loop may reach out of the one around it as far as diagnose() lets loops that touch overlap.
bool encloses(const Box2& outer, const Box2& inner) {
    const Box2 slack = grown(outer, 2 * Tolerances().linear_mm);
    return (slack.min().array() <= inner.min().array()).all() &&
           (slack.max().array() >= inner.max().array()).all();
}

struct Outer {
    Region component;
    Box2 box;
    double area_mm2 = 0;
};

/// The smallest outer loop around the hole, or nothing.
Outer* ownerOf(const Loop& hole, std::vector<Outer>& outers) {
    const Box2 box = boundingBox(hole);
    const double hole_area = -signedArea(hole);
    Outer* owner = nullptr;
    for (Outer& outer : outers) {
        if (outer.area_mm2 < hole_area || !encloses(outer.box, box)) continue;
        if (owner && owner->area_mm2 <= outer.area_mm2) continue;
        const Loop& boundary = outer.component.loops.front();
        if (planar::windingNumber(boundary, planar::pointAwayFrom(hole, boundary)) > 0) owner = &outer;
    }
    return owner;
}

}  // namespace

std::optional<std::vector<Region>> planar::componentsIfNested(const Region& region) {
    std::vector<Outer> outers;
    std::vector<Loop> holes;
    for (const Loop& loop : region.loops) {
        const double loop_area = signedArea(loop);
        if (loop_area > 0)
            outers.push_back({Region{{loop}}, boundingBox(loop), loop_area});
        else
            holes.push_back(loop);
    }
    std::sort(outers.begin(), outers.end(), [](const Outer& a, const Outer& b) {
        return lowerLeft(a.component.loops.front(), b.component.loops.front());
    });
    std::sort(holes.begin(), holes.end(), lowerLeft);
    for (const Loop& hole : holes) {
        // With one outer loop there is nothing to search.
        Outer* owner = outers.size() == 1 ? &outers.front() : ownerOf(hole, outers);
        if (!owner) return std::nullopt;
        owner->component.loops.push_back(hole);
    }
    std::vector<Region> result;
    for (Outer& outer : outers)
        result.push_back(std::move(outer.component));
    return result;
}

std::vector<Region> components(const Region& region) {
    auto parts = planar::componentsIfNested(region);
    if (!parts) throw Error(ErrorCode::InvalidRegion, "region", "a hole lies outside all outer loops");
    return *std::move(parts);
}

Region withoutHoles(const Region& region) {
    Region result;
    for (const Loop& loop : region.loops)
        if (signedArea(loop) > 0) result.loops.push_back(loop);
    // An island inside a filled hole is part of the filling.
    Region outermost;
    for (const Loop& loop : result.loops) {
        const bool covered = std::any_of(result.loops.begin(), result.loops.end(), [&](const Loop& other) {
            return &other != &loop && signedArea(other) > signedArea(loop) &&
                   encloses(boundingBox(other), boundingBox(loop)) &&
                   planar::windingNumber(other, planar::pointAwayFrom(loop, other)) > 0;
        });
        if (!covered) outermost.loops.push_back(loop);
    }
    return outermost;
}

Path reversed(const Path& path) {
    Path result{path.end(), {}};
    result.segments.reserve(path.segments.size());
    for (std::size_t i = path.segments.size(); i-- > 0;) {
        Segment segment{i == 0 ? path.start : path.segments[i - 1].to, path.segments[i].arc};
        if (segment.arc) segment.arc->ccw = !segment.arc->ccw;
        result.segments.push_back(segment);
    }
    return result;
}

Region translated(const Region& region, const Vec2& by) {
    Region result = region;
    const auto move = [&](Vec2& p) { p = snapToGrid(Vec2(p + by)); };
    for (Loop& loop : result.loops) {
        move(loop.start);
        for (Segment& segment : loop.segments) {
            move(segment.to);
            if (segment.arc) move(segment.arc->centre);
        }
    }
    return result;
}

}  // namespace stepmill
