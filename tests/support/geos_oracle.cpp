#include "support/geos_oracle.h"

#include <cmath>
#include <memory>

#ifndef USE_UNSTABLE_GEOS_CPP_API
#define USE_UNSTABLE_GEOS_CPP_API
#endif
#include <geos/geom/CoordinateArraySequence.h>
#include <geos/geom/Geometry.h>
#include <geos/geom/GeometryCollection.h>
#include <geos/geom/GeometryFactory.h>
#include <geos/geom/LinearRing.h>
#include <geos/geom/MultiPolygon.h>
#include <geos/geom/Polygon.h>
#include <geos/operation/overlayng/OverlayNGRobust.h>

#include "stepmill/core/units.h"
#include "stepmill/planar/edge.h"

namespace stepmill::test {
namespace {

using geos::operation::overlayng::OverlayNG;
using geos::operation::overlayng::OverlayNGRobust;
using Shape = std::unique_ptr<geos::geom::Geometry>;
using Points = std::vector<geos::geom::Coordinate>;

const geos::geom::GeometryFactory& factory() {
    return *geos::geom::GeometryFactory::getDefaultInstance();
}

std::unique_ptr<geos::geom::LinearRing> ring(Points points) {
    if (!points.front().equals2D(points.back())) points.push_back(points.front());
    return factory().createLinearRing(
        std::make_unique<geos::geom::CoordinateArraySequence>(std::move(points)));
}

Shape polygons(const Region& region, double chord_mm) {
    const auto closed = [&](const Loop& loop) {
        Points points;
        for (const Vec2& p : tessellate(loop, chord_mm))
            points.emplace_back(p.x(), p.y());
        return ring(std::move(points));
    };
    std::vector<Shape> parts;
    for (const Region& part : components(region)) {
        std::vector<std::unique_ptr<geos::geom::LinearRing>> holes;
        for (std::size_t i = 1; i < part.loops.size(); ++i)
            holes.push_back(closed(part.loops[i]));
        parts.push_back(factory().createPolygon(closed(part.loops[0]), std::move(holes)));
    }
    return factory().createMultiPolygon(std::move(parts));
}

/// Chords between points outside the arc, so that as much lies outside as inside.
void appendArc(Points& points, const Vec2& centre, double radius_mm, double from_rad, double sweep_rad,
               double chord_mm) {
    const double step_rad = 2 * std::acos(1 - std::min(0.1, chord_mm / radius_mm));
    const int steps = static_cast<int>(std::ceil(std::abs(sweep_rad) / step_rad));
    const double angle = sweep_rad / steps;
    const double out_mm = radius_mm * std::sqrt(angle / std::sin(angle));
    for (int i = 0; i <= steps; ++i) {
        const double at = from_rad + angle * i;
        points.emplace_back(centre.x() + out_mm * std::cos(at), centre.y() + out_mm * std::sin(at));
    }
}

Shape disc(const Vec2& centre, double radius_mm, double chord_mm) {
    Points points;
    appendArc(points, centre, radius_mm, 0, 2 * kPi, chord_mm);
    points.back() = points.front();
    return factory().createPolygon(ring(std::move(points)));
}

/// Points beside the edge, at its feet's distance up to that. Nothing for an edge of no length.
Shape strip(const Vec2& from, const Segment& segment, double distance_mm, double chord_mm) {
    Points points;
    if (!segment.arc) {
        const Vec2 along = (segment.to - from).normalized();
        const Vec2 left = distance_mm * leftOf(along);
        for (const Vec2& p :
             {Vec2(from + left), Vec2(from - left), Vec2(segment.to - left), Vec2(segment.to + left)})
            points.emplace_back(p.x(), p.y());
        return factory().createPolygon(ring(std::move(points)));
    }
    const Arc& arc = *segment.arc;
    const Vec2 to_start = from - arc.centre;
    const double start = std::atan2(to_start.y(), to_start.x());
    const double sweep = sweepAngle(from, segment.to, arc);
    appendArc(points, arc.centre, arc.radius_mm + distance_mm, start, sweep, chord_mm);
    if (arc.radius_mm > distance_mm + kGridMm)
        appendArc(points, arc.centre, arc.radius_mm - distance_mm, start + sweep, -sweep, chord_mm);
    else
        points.emplace_back(arc.centre.x(), arc.centre.y());
    return factory().createPolygon(ring(std::move(points)));
}

/// All points no farther from the boundary than that.
Shape aroundBoundary(const Region& region, double distance_mm, double chord_mm) {
    std::vector<Shape> parts;
    for (const auto& [from, segment] : eachEdge(region)) {
        parts.push_back(disc(segment.to, distance_mm, chord_mm));
        parts.push_back(strip(from, segment, distance_mm, chord_mm));
    }
    // Two by two, neighbours first.
    while (parts.size() > 1) {
        std::vector<Shape> next;
        for (std::size_t i = 0; i + 1 < parts.size(); i += 2)
            next.push_back(OverlayNGRobust::Overlay(parts[i].get(), parts[i + 1].get(), OverlayNG::UNION));
        if (parts.size() % 2) next.push_back(std::move(parts.back()));
        parts = std::move(next);
    }
    return std::move(parts.front());
}

}  // namespace

double geosOffsetArea(const Region& region, double distance_mm, double chord_mm) {
    const Shape shape = polygons(region, chord_mm);
    const Shape around = aroundBoundary(region, std::abs(distance_mm), chord_mm);
    const int operation = distance_mm > 0 ? OverlayNG::UNION : OverlayNG::DIFFERENCE;
    return OverlayNGRobust::Overlay(shape.get(), around.get(), operation)->getArea();
}

}  // namespace stepmill::test
