// Laws of the booleans on random regions: scattered ones, ones on a coarse lattice, where nearly every
// case is degenerate (shared edges, tangent arcs, equal circles, touching corners), and lattice ones that
// are shifted by a few nanometres up to a micrometre. GEOS on fine chords is the second opinion.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#ifndef USE_UNSTABLE_GEOS_CPP_API
#define USE_UNSTABLE_GEOS_CPP_API
#endif
#include <geos/geom/CoordinateArraySequence.h>
#include <geos/geom/Geometry.h>
#include <geos/geom/GeometryFactory.h>
#include <geos/geom/LinearRing.h>
#include <geos/geom/Polygon.h>
#include <geos/operation/overlayng/OverlayNG.h>
#include <geos/operation/overlayng/OverlayNGRobust.h>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/region_text.h"

namespace stepmill {
namespace {

enum class Kind { Scattered, Lattice, Shifted };

class Shapes {
  public:
    Shapes(unsigned seed, Kind kind) : random_(seed), kind_(kind) {}

    Region region() {
        std::vector<Region> parts(1 + below(4));
        for (Region& part : parts)
            part = shape();
        return unite(parts, Tolerances());
    }

    Path path() {
        Path result{{coordinate(), coordinate()}, {}};
        for (unsigned i = 0, n = 1 + below(4); i < n; ++i) {
            const Vec2 from = result.end();
            Vec2 to(coordinate(), coordinate());
            if (to == from) to.x() += 5;
            if (below(2) == 0) {
                const Vec2 centre = snapToGrid(Vec2((from + to) / 2));
                const double radius_mm = snapToGrid((from - centre).norm());
                result.segments.push_back({to, Arc{centre, radius_mm, below(2) == 0}});
            } else {
                result.segments.push_back({to, std::nullopt});
            }
        }
        return result;
    }

  private:
    unsigned below(unsigned n) { return static_cast<unsigned>(random_() % n); }
    double real(double low, double high) { return low + (high - low) * (random_() / 4294967296.0); }
    double coordinate() { return kind_ == Kind::Scattered ? snapToGrid(real(0, 40)) : 5.0 * below(9); }
    double size() { return kind_ == Kind::Scattered ? real(1, 20) : 5.0 * (1 + below(4)); }

    Region shape() {
        const Vec2 p(coordinate(), coordinate());
        const double w = size();
        const double h = size();
        Region result;
        switch (below(6)) {
            case 0:
                result = makeRectangle(p, p + Vec2(w, h));
                break;
            case 1:
                result = makeCircle(p, w / 2);
                break;
            case 2:
                result = makeRoundedRectangle(p, p + Vec2(w, h),
                                              kind_ == Kind::Scattered ? real(0, std::min(w, h) / 2) : 2.5);
                break;
            case 3:
                result = makePolygon({p, p + Vec2(w, 0), p + Vec2(0, w)});
                break;
            case 4:
                result = makeCircle(p, w);
                result.loops.push_back(reversed(makeCircle(p, w / 2).loops.front()));
                break;
            default:
                result = makePolygon(
                    {p + Vec2(w / 2, 0), p + Vec2(0, w / 2), p - Vec2(w / 2, 0), p - Vec2(0, w / 2)});
        }
        if (kind_ != Kind::Shifted) return result;
        const double by_mm = 1e-6 * std::pow(10.0, below(4));
        return translated(result, {real(-by_mm, by_mm), real(-by_mm, by_mm)});
    }

    std::mt19937 random_;
    Kind kind_;
};

using GeosGeometry = std::unique_ptr<geos::geom::Geometry>;

/// The region with chords of 10 nm for arcs.
GeosGeometry toGeos(const Region& region) {
    const auto& factory = *geos::geom::GeometryFactory::getDefaultInstance();
    const auto ringOf = [&](const Loop& loop) {
        std::vector<geos::geom::Coordinate> points;
        for (const Vec2& p : tessellate(loop, 1e-5))
            points.emplace_back(p.x(), p.y());
        return factory.createLinearRing(
            std::make_unique<geos::geom::CoordinateArraySequence>(std::move(points)));
    };
    std::vector<GeosGeometry> polygons;
    for (const Region& part : components(region)) {
        std::vector<std::unique_ptr<geos::geom::LinearRing>> holes;
        for (std::size_t i = 1; i < part.loops.size(); ++i)
            holes.push_back(ringOf(part.loops[i]));
        polygons.push_back(factory.createPolygon(ringOf(part.loops[0]), std::move(holes)));
    }
    return factory.createMultiPolygon(std::move(polygons));
}

double geosArea(const GeosGeometry& a, const GeosGeometry& b, int operation) {
    return geos::operation::overlayng::OverlayNGRobust::Overlay(a.get(), b.get(), operation)->getArea();
}

std::string drawing(unsigned seed, const Region& a, const Region& b) {
    return "seed " + std::to_string(seed) + "\na\n" + toText(a) + "b\n" + toText(b);
}

void expectLaws(unsigned seed, Kind kind) {
    const Tolerances tol;
    Shapes shapes(seed, kind);
    const Region a = shapes.region();
    const Region b = shapes.region();
    SCOPED_TRACE(drawing(seed, a, b));
    const Region both = unite(a, b, tol);
    const Region common = intersect(a, b, tol);
    const Region only_a = subtract(a, b, tol);
    const Region only_b = subtract(b, a, tol);
    // Boundaries that differ by less than the tolerance may move by it.
    const double slack = kind == Kind::Shifted ? 2 * tol.linear_mm * (perimeter(a) + perimeter(b))
                                               : 1e-6 * (1 + area(a) + area(b));
    EXPECT_NEAR(area(both) + area(common), area(a) + area(b), slack);
    EXPECT_NEAR(area(only_a) + area(common), area(a), slack);
    EXPECT_NEAR(area(only_b) + area(common), area(b), slack);
    EXPECT_NEAR(area(unite(only_a, common, tol)), area(a), slack) << "parts make the whole";
    EXPECT_NEAR(area(intersect(only_a, b, tol)), 0, slack) << "parts do not overlap";
    EXPECT_TRUE(subtract(only_a, only_a, tol).empty());
    EXPECT_NEAR(area(unite(both, a, tol)), area(both), slack) << "idempotent";
    EXPECT_NEAR(area(unite(b, a, tol)), area(both), slack) << "commutative";
    EXPECT_NEAR(area(intersect(b, a, tol)), area(common), slack) << "commutative";
    if (kind == Kind::Shifted) return;
    for (const Region* result : {&both, &common, &only_a, &only_b}) {
        const auto trouble = diagnose(*result);
        EXPECT_FALSE(trouble.has_value()) << *trouble << "\n" << toText(*result);
        EXPECT_EQ(toText(regionFromText(toText(*result), "again")), toText(*result));
    }
}

TEST(BooleanLaws, HoldOnScatteredShapes) {
    for (unsigned seed = 1; seed <= 1500 && !HasFailure(); ++seed)
        expectLaws(seed, Kind::Scattered);
}

TEST(BooleanLaws, HoldOnALatticeWhereEverythingTouches) {
    for (unsigned seed = 1; seed <= 1500 && !HasFailure(); ++seed)
        expectLaws(seed, Kind::Lattice);
}

TEST(BooleanLaws, HoldWhenWallsMissEachOtherByNanometres) {
    for (unsigned seed = 1; seed <= 1500 && !HasFailure(); ++seed)
        expectLaws(seed, Kind::Shifted);
}

TEST(BooleanLaws, AgreeWithGeosOnFineChords) {
    using geos::operation::overlayng::OverlayNG;
    const Tolerances tol;
    for (unsigned seed = 1; seed <= 60 && !HasFailure(); ++seed) {
        Shapes shapes(seed, seed % 2 ? Kind::Lattice : Kind::Scattered);
        const Region a = shapes.region();
        const Region b = shapes.region();
        SCOPED_TRACE(drawing(seed, a, b));
        const GeosGeometry ga = toGeos(a);
        const GeosGeometry gb = toGeos(b);
        // Chords of 10 nm lose at most two thirds of that along all arcs.
        const double slack = 1e-5 * (perimeter(a) + perimeter(b));
        EXPECT_NEAR(area(unite(a, b, tol)), geosArea(ga, gb, OverlayNG::UNION), slack);
        EXPECT_NEAR(area(intersect(a, b, tol)), geosArea(ga, gb, OverlayNG::INTERSECTION), slack);
        EXPECT_NEAR(area(subtract(a, b, tol)), geosArea(ga, gb, OverlayNG::DIFFERENCE), slack);
    }
}

TEST(BooleanLaws, EveryResultEdgeLiesOnAnOperandsBoundary) {
    const Tolerances tol;
    for (unsigned seed = 1; seed <= 500 && !HasFailure(); ++seed) {
        Shapes shapes(seed, Kind::Scattered);
        const Region a = shapes.region();
        const Region b = shapes.region();
        SCOPED_TRACE(drawing(seed, a, b));
        for (const Loop& loop : subtract(a, b, tol).loops) {
            Vec2 from = loop.start;
            for (const Segment& segment : loop.segments) {
                for (const double t : {0.1, 0.5, 0.9}) {
                    const Vec2 p = pointAt(from, segment, t);
                    EXPECT_LE(std::min(distanceToBoundary(a, p), distanceToBoundary(b, p)), 3 * kGridMm);
                }
                from = segment.to;
            }
        }
    }
}

TEST(SplitLaws, PiecesAddUpAndLieWhereTheyAreSaidToLie) {
    const Tolerances tol;
    for (unsigned seed = 1; seed <= 2000 && !HasFailure(); ++seed) {
        Shapes shapes(seed, seed % 2 ? Kind::Lattice : Kind::Scattered);
        const Region region = shapes.region();
        const Path path = shapes.path();
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + toText(region) + toSvgPath(path));
        const SplitPath parts = split(path, region, tol);
        double sum = 0;
        const auto check = [&](const std::vector<Path>& pieces, const auto& holdsAt) {
            for (const Path& piece : pieces) {
                sum += length(piece);
                Vec2 from = piece.start;
                for (const Segment& segment : piece.segments) {
                    for (const double t : {0.3, 0.7})
                        EXPECT_TRUE(holdsAt(pointAt(from, segment, t)));
                    from = segment.to;
                }
            }
        };
        check(parts.inside, [&](const Vec2& p) { return contains(region, p); });
        check(parts.on, [&](const Vec2& p) { return distanceToBoundary(region, p) <= tol.linear_mm; });
        check(parts.outside, [&](const Vec2& p) {
            return !contains(region, p) || distanceToBoundary(region, p) <= tol.linear_mm;
        });
        EXPECT_NEAR(sum, length(path), 1e-6 * (1 + length(path)));
    }
}

}  // namespace
}  // namespace stepmill
