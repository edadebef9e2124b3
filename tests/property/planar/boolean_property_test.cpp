// Laws of the booleans on random pairs of regions of eight kinds, most of them degenerate: areas add up,
// every result is a valid region, and neither the order of operands nor where or how they are written down
// matters. GEOS on fine chords is the second opinion.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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

#include "boolean_pairs.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/region_text.h"
#include "stepmill/planar/svg_path.h"
#include "support/random_regions.h"

namespace stepmill {
namespace {

using test::PairKind;
using test::PairMaker;

using GeosGeometry = std::unique_ptr<geos::geom::Geometry>;

GeosGeometry toGeos(const Region& region, double chord_mm) {
    const auto& factory = *geos::geom::GeometryFactory::getDefaultInstance();
    const auto ringOf = [&](const Loop& loop) {
        std::vector<geos::geom::Coordinate> points;
        for (const Vec2& p : tessellate(loop, chord_mm))
            points.emplace_back(p.x(), p.y());
        return factory.createLinearRing(
            std::make_unique<geos::geom::CoordinateArraySequence>(std::move(points)));
    };
    // Loop by loop: chords of loops that touch overlap there, and GEOS refuses such polygons.
    using geos::operation::overlayng::OverlayNG;
    using geos::operation::overlayng::OverlayNGRobust;
    GeosGeometry whole;
    for (const Region& part : components(region)) {
        GeosGeometry piece = factory.createPolygon(ringOf(part.loops[0]));
        for (std::size_t i = 1; i < part.loops.size(); ++i) {
            const GeosGeometry hole = factory.createPolygon(ringOf(part.loops[i]));
            piece = OverlayNGRobust::Overlay(piece.get(), hole.get(), OverlayNG::DIFFERENCE);
        }
        whole =
            whole ? OverlayNGRobust::Overlay(whole.get(), piece.get(), OverlayNG::UNION) : std::move(piece);
    }
    return whole;
}

double geosArea(const GeosGeometry& a, const GeosGeometry& b, int operation) {
    return geos::operation::overlayng::OverlayNGRobust::Overlay(a.get(), b.get(), operation)->getArea();
}

std::string drawing(unsigned seed, const Region& a, const Region& b) {
    return "seed " + std::to_string(seed) + "\na\n" + toText(a) + "b\n" + toText(b);
}

void expectValid(const Region& result) {
    const auto trouble = diagnose(result);
    EXPECT_FALSE(trouble.has_value()) << *trouble << "\n" << toText(result);
    EXPECT_EQ(toText(regionFromText(toText(result), "again")), toText(result));
}

/// Boundaries that differ by less than the tolerance may move by it; where none do, nothing moves.
double slackMm2(PairKind kind, const Region& a, const Region& b) {
    if (kind == PairKind::Scattered || kind == PairKind::Lattice) return 1e-6 * (1 + area(a) + area(b));
    return 2 * Tolerances().linear_mm * (perimeter(a) + perimeter(b));
}

void expectLaws(const Region& a, const Region& b, double slack) {
    const Tolerances tol;
    const Region both = unite(a, b, tol);
    const Region common = intersect(a, b, tol);
    const Region only_a = subtract(a, b, tol);
    const Region only_b = subtract(b, a, tol);
    for (const Region* result : {&both, &common, &only_a, &only_b})
        expectValid(*result);
    EXPECT_NEAR(area(both) + area(common), area(a) + area(b), slack);
    EXPECT_NEAR(area(only_a) + area(common), area(a), slack);
    EXPECT_NEAR(area(only_b) + area(common), area(b), slack);
    EXPECT_NEAR(area(unite(only_a, common, tol)), area(a), slack) << "parts make the whole";
    EXPECT_NEAR(area(intersect(only_a, b, tol)), 0, slack) << "parts do not overlap";
    EXPECT_TRUE(subtract(only_a, only_a, tol).empty());
    EXPECT_NEAR(area(unite(both, a, tol)), area(both), slack) << "idempotent";
}

/// The same point sets, written down or laid down otherwise, give the same results.
void expectInvariance(unsigned seed, const Region& a, const Region& b, double slack) {
    const Tolerances tol;
    const double both = area(unite(a, b, tol));
    const double only_a = area(subtract(a, b, tol));
    EXPECT_NEAR(area(unite(b, a, tol)), both, slack) << "operands swapped";
    EXPECT_NEAR(area(intersect(b, a, tol)), area(intersect(a, b, tol)), slack) << "operands swapped";
    const auto expectSame = [&](const Region& other_a, const Region& other_b, const char* how) {
        SCOPED_TRACE(how);
        const Region united = unite(other_a, other_b, tol);
        const Region rest = subtract(other_a, other_b, tol);
        EXPECT_NEAR(area(united), both, slack);
        EXPECT_NEAR(area(rest), only_a, slack);
        expectValid(united);
        expectValid(rest);
    };
    expectSame(test::mirrored(a), test::mirrored(b), "mirrored");
    const Vec2 by(-123.456789, 77.000003);
    expectSame(translated(a, by), translated(b, by), "moved");
    test::Random random(seed);
    const Region renumbered = test::renumbered(a, random);
    expectSame(renumbered, test::renumbered(b, random), "started at other vertices");
}

class BooleanLaws : public testing::TestWithParam<PairKind> {};

TEST_P(BooleanLaws, Hold) {
    const PairKind kind = GetParam();
    for (unsigned seed = 1; seed <= 1200 && !HasFailure(); ++seed) {
        PairMaker maker(seed, kind);
        const Region a = maker.region();
        const Region b = maker.region();
        SCOPED_TRACE(drawing(seed, a, b));
        expectValid(a);
        const double slack = slackMm2(kind, a, b);
        expectLaws(a, b, slack);
        if (seed % 3 == 0) expectInvariance(seed, a, b, slack);
    }
}

std::string nameOf(const testing::TestParamInfo<PairKind>& which) {
    const char* const all[] = {"Scattered", "Lattice", "Shifted", "Turned",
                               "Tangent",   "Chained", "Tiny",    "Huge"};
    return all[static_cast<std::size_t>(which.param)];
}
INSTANTIATE_TEST_SUITE_P(Pairs, BooleanLaws, testing::ValuesIn(test::kPairKinds), nameOf);

TEST(BooleanOracles, GeosOnFineChordsAgrees) {
    using geos::operation::overlayng::OverlayNG;
    const Tolerances tol;
    // Chords of 10 nm on small regions, of 100 nm on metre-long ones, where finer ones cost seconds.
    for (unsigned seed = 1; seed <= 80 && !HasFailure(); ++seed) {
        // No kind whose operands may touch themselves to within the tolerance: GEOS calls those invalid.
        const PairKind kinds[] = {PairKind::Scattered, PairKind::Lattice, PairKind::Tiny, PairKind::Huge};
        const PairKind kind = kinds[seed % 4];
        const double chord_mm = kind == PairKind::Huge ? 1e-4 : 1e-5;
        PairMaker shapes(seed, kind);
        const Region a = shapes.region();
        const Region b = shapes.region();
        SCOPED_TRACE(drawing(seed, a, b));
        const GeosGeometry ga = toGeos(a, chord_mm);
        const GeosGeometry gb = toGeos(b, chord_mm);
        // Chords lose at most two thirds of their sagitta along all arcs.
        const double slack = chord_mm * (perimeter(a) + perimeter(b)) + slackMm2(kind, a, b);
        EXPECT_NEAR(area(unite(a, b, tol)), geosArea(ga, gb, OverlayNG::UNION), slack);
        EXPECT_NEAR(area(intersect(a, b, tol)), geosArea(ga, gb, OverlayNG::INTERSECTION), slack);
        EXPECT_NEAR(area(subtract(a, b, tol)), geosArea(ga, gb, OverlayNG::DIFFERENCE), slack);
    }
}

TEST(BooleanOracles, EveryResultEdgeLiesOnAnOperandsBoundary) {
    const Tolerances tol;
    for (unsigned seed = 1; seed <= 500 && !HasFailure(); ++seed) {
        PairMaker shapes(seed, PairKind::Scattered);
        const Region a = shapes.region();
        const Region b = shapes.region();
        SCOPED_TRACE(drawing(seed, a, b));
        for (const Loop& loop : subtract(a, b, tol).loops) {
            for (const auto& [from, segment] : eachEdge(loop)) {
                for (const double t : {0.1, 0.5, 0.9}) {
                    const Vec2 p = pointAt(from, segment, t);
                    EXPECT_LE(std::min(distanceToBoundary(a, p), distanceToBoundary(b, p)), 3 * kGridMm);
                }
            }
        }
    }
}

TEST(SubtractLaws, ManyAtOnceLeaveWhatTheirUnionDoes) {
    const Tolerances tol;
    for (unsigned seed = 1; seed <= 300 && !HasFailure(); ++seed) {
        const PairKind kind = seed % 2 ? PairKind::Scattered : PairKind::Lattice;
        PairMaker shapes(seed, kind);
        const Region a = shapes.region();
        std::vector<Region> many;
        for (unsigned i = 0; i < seed % 60; ++i)
            many.push_back(shapes.region());
        const Region united = unite(many, tol);
        SCOPED_TRACE(drawing(seed, a, united));
        const Region left = subtract(a, many, tol);
        expectValid(left);
        const double slack = slackMm2(kind, a, united);
        EXPECT_NEAR(area(left), area(subtract(a, united, tol)), slack);
        EXPECT_LE(area(intersect(left, united, tol)), slack);
    }
}

TEST(SplitLaws, PiecesAddUpAndLieWhereTheyAreSaidToLie) {
    const Tolerances tol;
    for (unsigned seed = 1; seed <= 2000 && !HasFailure(); ++seed) {
        PairMaker shapes(seed, seed % 2 ? PairKind::Lattice : PairKind::Scattered);
        const Region region = shapes.region();
        const Path path = shapes.path();
        SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + toText(region) + toSvgPath(path, kGridMm));
        const SplitPath parts = split(path, region, tol);
        double sum = 0;
        const auto check = [&](const std::vector<Path>& pieces, const auto& holdsAt) {
            for (const Path& piece : pieces) {
                sum += length(piece);
                for (const auto& [from, segment] : eachEdge(piece)) {
                    for (const double t : {0.3, 0.7})
                        EXPECT_TRUE(holdsAt(pointAt(from, segment, t)));
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
