#include <cmath>

#include <geos/geom/CoordinateArraySequence.h>
#include <geos/geom/Geometry.h>
#include <geos/geom/GeometryFactory.h>
#include <geos/geom/LinearRing.h>
#include <geos/geom/Polygon.h>
#include <geos/operation/buffer/BufferOp.h>
#include <geos/operation/buffer/BufferParameters.h>
#include <geos/operation/overlayng/OverlayNGRobust.h>

#include "bench/kernels.h"
#include "stepmill/core/units.h"

namespace stepmill::bench {
namespace {

using geos::geom::Geometry;
using geos::operation::buffer::BufferOp;
using geos::operation::buffer::BufferParameters;
using geos::operation::overlayng::OverlayNG;
using geos::operation::overlayng::OverlayNGRobust;
using Shape = std::unique_ptr<Geometry>;

std::unique_ptr<geos::geom::LinearRing> ring(const geos::geom::GeometryFactory& factory, const Loop& loop) {
    std::vector<geos::geom::Coordinate> points;
    for (const Vec2& p : tessellate(loop, kChordMm))
        points.emplace_back(p.x(), p.y());
    return factory.createLinearRing(std::make_unique<geos::geom::CoordinateArraySequence>(std::move(points)));
}

/// \pre one outer loop, first, as the shapes of the bench have
Shape polygon(const Region& region) {
    const geos::geom::GeometryFactory& factory = *geos::geom::GeometryFactory::getDefaultInstance();
    std::vector<std::unique_ptr<geos::geom::LinearRing>> holes;
    for (std::size_t i = 1; i < region.loops.size(); ++i)
        holes.push_back(ring(factory, region.loops[i]));
    return factory.createPolygon(ring(factory, region.loops.front()), std::move(holes));
}

Shape grown(const Geometry& shape, double distance_mm) {
    // Chords of the same sagitta as the input: a quarter turn takes this many.
    const double step_rad = 2 * std::acos(1 - kChordMm / std::abs(distance_mm));
    const BufferParameters parameters(std::max(1, static_cast<int>(std::ceil(kPi / 2 / step_rad))));
    return BufferOp(&shape, parameters).getResultGeometry(distance_mm);
}

}  // namespace

double GeosKernel::openings(const Region& region, const std::vector<double>& radii_mm) const {
    const Shape shape = polygon(region);
    double sum = 0;
    for (const double radius : radii_mm)
        sum += grown(*grown(*shape, -radius), radius)->getArea();
    return sum;
}

double GeosKernel::insets(const Region& region, const std::vector<double>& distances_mm) const {
    const Shape shape = polygon(region);
    double sum = 0;
    for (const double distance : distances_mm)
        sum += grown(*shape, -distance)->getArea();
    return sum;
}

double GeosKernel::rings(const Region& region, double step_mm) const {
    const Shape shape = polygon(region);
    double sum = 0;
    for (double distance = step_mm / 2;; distance += step_mm) {
        const Shape ring = grown(*shape, -distance);
        if (ring->isEmpty()) return sum;
        sum += ring->getArea();
    }
}

Pairs GeosKernel::decomposed(const Region& region, const std::vector<double>& radii_mm,
                             double budget_s) const {
    const double start_s = processorSeconds();
    const Shape shape = polygon(region);
    std::vector<Shape> centres;
    std::vector<Shape> accessible;
    for (const double radius : radii_mm) {
        centres.push_back(grown(*shape, -radius));
        accessible.push_back(grown(*centres.back(), radius));
    }
    return runPairs(radii_mm.size(), start_s, budget_s, [&](std::size_t m, std::size_t n) {
        const Shape done = grown(*accessible[m], -radii_mm[n]);
        const Shape left = OverlayNGRobust::Overlay(centres[n].get(), done.get(), OverlayNG::DIFFERENCE);
        return grown(*left, radii_mm[n])->getArea();
    });
}

}  // namespace stepmill::bench
