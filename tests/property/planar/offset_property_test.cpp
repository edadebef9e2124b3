#include <gtest/gtest.h>

#include <random>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"

namespace stepmill {
namespace {

const Tolerances kTol;
constexpr int kSeeds = 40;

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

/// Coordinates on a coarse lattice make ties: equal radii, tangent arcs, necks of equal width.
double coordinate(Random& random, bool lattice, double low, double high) {
    const double x = uniform(random, low, high);
    return lattice ? std::round(2 * x) / 2 : x;
}

Region randomShape(Random& random, bool lattice) {
    const Vec2 at(coordinate(random, lattice, -10, 10), coordinate(random, lattice, -10, 10));
    const Vec2 size(coordinate(random, lattice, 3, 14), coordinate(random, lattice, 3, 14));
    switch (random() % 3) {
        case 0:
            return makeRectangle(at, at + size);
        case 1:
            return makeCircle(at, size.x() / 2);
        default:
            return makeRoundedRectangle(
                at, at + size, size.minCoeff() / (lattice ? 2.0 + static_cast<double>(random() % 3) : 2.1));
    }
}

Region randomRegion(Random& random, bool lattice) {
    Region region = randomShape(random, lattice);
    for (std::size_t k = random() % 6; k > 0; --k) {
        const Region shape = randomShape(random, lattice);
        region = random() % 3 ? unite(region, shape, kTol) : subtract(region, shape, kTol);
    }
    return region;
}

double signedClearance(const Region& region, const Vec2& p) {
    const double distance = distanceToBoundary(region, p);
    return contains(region, p) ? distance : -distance;
}

Vec2 randomPoint(Random& random, const Box2& box) {
    return {uniform(random, box.min.x(), box.max.x()), uniform(random, box.min.y(), box.max.y())};
}

/// Every point of the offset is as far from the boundary as asked, and the offset's inside is where
/// clearance says it is.
void expectOffset(const Region& region, const Region& result, double distance, Random& random) {
    constexpr double kGridRounding_mm = 4e-6;
    for (const Loop& loop : result.loops) {
        Vec2 from = loop.start;
        for (const Segment& s : loop.segments) {
            for (double t : {0.0, 0.3, 0.7}) {
                const double off = distanceToBoundary(region, pointAt(from, s, t)) - std::abs(distance);
                EXPECT_GT(off, -kGridRounding_mm);
                EXPECT_LT(off, kTol.linear_mm);
            }
            from = s.to;
        }
    }
    const Box2 box = boundingBox(region).grown(std::max(0.0, distance) + 1);
    for (int k = 0; k < 100; ++k) {
        const Vec2 p = randomPoint(random, box);
        const double above = signedClearance(region, p) + distance;
        if (std::abs(above) > 2 * kTol.linear_mm) {
            EXPECT_EQ(contains(result, p), above > 0) << p.transpose();
        }
    }
}

class OffsetLaws : public testing::TestWithParam<bool> {};

TEST_P(OffsetLaws, EveryPointHasTheDistanceAndNothingIsMissing) {
    for (int seed = 0; seed < kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed));
        const Region region = randomRegion(random, GetParam());
        const ClearanceDiagram diagram(region, kTol);
        for (int k = 0; k < 4; ++k) {
            const double d = coordinate(random, GetParam(), 0.5, 4);
            for (double distance : {d, -d}) {
                SCOPED_TRACE(distance);
                const Region result = diagram.offset(distance);
                EXPECT_EQ(diagnose(result), std::nullopt);
                expectOffset(region, result, snapToGrid(distance), random);
            }
        }
    }
}

TEST_P(OffsetLaws, ErosionsAdd) {
    for (int seed = 0; seed < kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 1000);
        const Region region = randomRegion(random, GetParam());
        const double first = coordinate(random, GetParam(), 0.5, 1.5),
                     second = coordinate(random, GetParam(), 0.5, 1.5);
        const ClearanceDiagram diagram(region, kTol);
        const Region twice = offset(diagram.offset(-first), -second, kTol);
        const Region once = diagram.offset(-(first + second));
        EXPECT_NEAR(area(twice), area(once), 1e-6 * perimeter(region));
    }
}

TEST_P(OffsetLaws, OpeningLiesInsideAndShrinksAsTheCutterGrows) {
    for (int seed = 0; seed < kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 2000);
        const Region region = randomRegion(random, GetParam());
        const ClearanceDiagram diagram(region, kTol);
        double last = area(region);
        for (double radius : {0.5, 1.0, 1.75, 2.5}) {
            SCOPED_TRACE(radius);
            const Region opened = diagram.opening(radius);
            const double slack = 2e-6 * perimeter(region);
            EXPECT_LE(area(opened), last + slack);
            last = area(opened);
            EXPECT_TRUE(covers(region, opened, 4e-6, kTol));
        }
    }
}

TEST_P(OffsetLaws, OpeningTwiceIsOpeningOnce) {
    for (int seed = 0; seed < kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 4000);
        const Region region = randomRegion(random, GetParam());
        const double radius = coordinate(random, GetParam(), 0.5, 2.5);
        const Region once = ClearanceDiagram(region, kTol).opening(radius);
        const Region twice = ClearanceDiagram(once, kTol).opening(radius);
        EXPECT_NEAR(area(twice), area(once), 1e-6 * std::max(1.0, area(once)));
    }
}

TEST_P(OffsetLaws, TranslationAndStartVertexDoNotMatter) {
    for (int seed = 0; seed < kSeeds; ++seed) {
        SCOPED_TRACE(seed);
        Random random(static_cast<std::uint64_t>(seed) + 3000);
        const Region region = randomRegion(random, GetParam());
        Region moved = translated(region, {123.456789, -98.765432});
        for (Loop& loop : moved.loops) {
            std::rotate(loop.segments.begin(), loop.segments.begin() + 1, loop.segments.end());
            loop.start = loop.segments.back().to;
        }
        const double d = coordinate(random, GetParam(), 0.5, 3);
        for (double distance : {d, -d}) {
            const Region a = offset(region, distance, kTol), b = offset(moved, distance, kTol);
            EXPECT_EQ(a.loops.size(), b.loops.size());
            EXPECT_NEAR(area(a), area(b), 1e-6 * perimeter(region));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Random, OffsetLaws, testing::Values(false, true), [](const auto& which) {
    return which.param ? std::string("OnALattice") : std::string("Anywhere");
});

}  // namespace
}  // namespace stepmill
