// Laws of the openings of one ClearanceDiagram, of their areas, and of what a smaller cutter has left to do.

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/edge.h"
#include "stepmill/planar/region_text.h"
#include "support/diagram_laws.h"

namespace stepmill::test {
namespace {

class OpeningLaws : public DiagramLaws {};

/// Openings are offsets there and back.
double slackOf(const RandomRegion& which) {
    return 2 * kRoundingMm * perimeter(which.region);
}

std::size_t edges(const Region& region) {
    std::size_t count = 0;
    for (const Loop& loop : region.loops)
        count += loop.segments.size();
    return count;
}

TEST_P(OpeningLaws, LiesInsideAndShrinksAsTheCutterGrows) {
    forSeeds(150, [](const RandomRegion& which, Random& random) {
        const ClearanceDiagram diagram(which.region, kTol);
        std::vector<double> radii;
        for (int k = 0; k < 5; ++k)
            radii.push_back(radius(which, diagram, random));
        std::sort(radii.begin(), radii.end());
        double last = area(which.region);
        for (const double r : radii) {
            SCOPED_TRACE(fmt::format("opening {:.6f}", r));
            const Region opened = diagram.opening(r);
            const auto trouble = diagnose(opened);
            EXPECT_EQ(trouble, std::nullopt);
            EXPECT_LE(area(opened), last + slackOf(which));
            last = area(opened);
            for (const auto& [from, segment] : eachEdge(opened)) {
                for (const double t : {0.0, 0.5}) {
                    const Vec2 p = pointAt(from, segment, t);
                    EXPECT_GT(signedClearance(which.region, p), -kRoundingMm) << p.transpose();
                }
            }
        }
    });
}

TEST_P(OpeningLaws, WithoutStripsIsARegionBetweenTheOpeningAndTheWhole) {
    forSeeds(150, [](const RandomRegion& which, Random&) {
        const ClearanceDiagram diagram(which.region, kTol);
        for (const double width : {kTol.sliver_mm, 10 * kTol.sliver_mm}) {
            SCOPED_TRACE(fmt::format("strips of {}", width));
            const Region kept = diagram.withoutStrips(width);
            EXPECT_EQ(diagnose(kept), std::nullopt);
            EXPECT_LE(area(kept), area(which.region) + slackOf(which));
            // Straight ends take what the discs there would keep, half of one each at most.
            const double ends_mm2 = static_cast<double>(edges(kept)) * width * width;
            EXPECT_GE(area(kept), diagram.accessibleArea(width / 2) - slackOf(which) - ends_mm2);
        }
    });
}

TEST_P(OpeningLaws, HoldsWhatDiscsSweepAndNothingElse) {
    forSeeds(200, [](const RandomRegion& which, Random& random) {
        const ClearanceDiagram diagram(which.region, kTol);
        for (int k = 0; k < 3; ++k) {
            const double r = radius(which, diagram, random);
            SCOPED_TRACE(fmt::format("opening {:.6f}", r));
            const Region opened = diagram.opening(r);
            // At a tie a neck or a room may count either way.
            const Region surely = diagram.offset(-(r + kTieMm));
            const Region perhaps = diagram.offset(-std::max(r / 2, r - kTieMm));
            for (int i = 0; i < 24; ++i) {
                const Vec2 p = probePoint(which.region, 0, random);
                if (sweptBy(surely, r, p) > kTieMm) {
                    EXPECT_TRUE(contains(opened, p)) << p.transpose() << " is swept";
                }
                if (sweptBy(perhaps, r, p) < -kTieMm) {
                    EXPECT_FALSE(contains(opened, p)) << p.transpose() << " is not swept";
                }
            }
        }
    });
}

TEST_P(OpeningLaws, OpeningTwiceIsOpeningOnce) {
    forSeeds(100, [](const RandomRegion& which, Random& random) {
        const ClearanceDiagram diagram(which.region, kTol);
        const double r = radius(which, diagram, random);
        SCOPED_TRACE(fmt::format("opening {:.6f}", r));
        const Region once = diagram.opening(r);
        const Region twice = ClearanceDiagram(once, kTol).opening(r);
        EXPECT_NEAR(area(twice), area(once), slackOf(which));
    });
}

TEST_P(OpeningLaws, AccessibleAreaIsTheOpeningsArea) {
    forSeeds(150, [](const RandomRegion& which, Random& random) {
        const ClearanceDiagram diagram(which.region, kTol);
        for (int k = 0; k < 6; ++k) {
            const double r = radius(which, diagram, random);
            SCOPED_TRACE(fmt::format("radius {:.6f}", r));
            EXPECT_NEAR(diagram.accessibleArea(r), area(diagram.opening(r)), slackOf(which));
        }
    });
}

/// restCentres against its definition by Booleans and, point by point, without them.
void expectRest(const RandomRegion& which, const ClearanceDiagram& diagram, double large, double small,
                Random& random) {
    SCOPED_TRACE(fmt::format("restCentres {:.6f} {:.6f}", large, small));
    const Region rest = diagram.restCentres(large, small);
    const Region centres = diagram.offset(-small);
    const Region done = diagram.opening(large);
    const auto trouble = diagnose(rest);
    EXPECT_EQ(trouble, std::nullopt);
    for (int i = 0; i < 24; ++i) {
        const Vec2 p = probePoint(which.region, 0, random);
        const double free = signedClearance(which.region, p) - small;
        const double swept = signedClearance(done, p) - small;
        if (std::abs(free) < kTieMm || std::abs(swept) < kTieMm) continue;
        EXPECT_EQ(contains(rest, p), free > 0 && swept < 0)
            << p.transpose() << " free by " << free << ", swept by " << swept;
    }
    if (toText(done) == toText(diagram.opening(small))) {
        EXPECT_TRUE(rest.empty()) << "equal openings";
    }
    const Deviation off = deviation(rest, which.region, small);
    EXPECT_LT(off.too_close_mm, kRoundingMm) << "at " << off.closest_at.transpose();
    // Strips along shared walls, thinner than the tolerance, are in one of the two and not in the other.
    const Region expected = subtract(centres, offset(done, -small, kTol), kTol);
    EXPECT_NEAR(area(rest), area(expected), kTol.linear_mm * perimeter(centres) + slackOf(which));
}

TEST_P(OpeningLaws, RestCentresAreWhatTheyAreSaidToBe) {
    forSeeds(120, [](const RandomRegion& which, Random& random) {
        const ClearanceDiagram diagram(which.region, kTol);
        for (int k = 0; k < 3; ++k) {
            const double a = radius(which, diagram, random);
            const double b = radius(which, diagram, random);
            expectRest(which, diagram, std::max(a, b), std::min(a, b), random);
        }
        const double r = radius(which, diagram, random);
        EXPECT_TRUE(diagram.restCentres(r, r).empty()) << r;
    });
}

TEST_P(OpeningLaws, LargeAndRestTogetherSweepWhatTheSmallCutterSweeps) {
    forSeeds(120, [](const RandomRegion& which, Random& random) {
        const ClearanceDiagram diagram(which.region, kTol);
        const double a = radius(which, diagram, random);
        const double b = radius(which, diagram, random);
        const double large = std::max(a, b);
        const double small = std::min(a, b);
        SCOPED_TRACE(fmt::format("large {:.6f} small {:.6f}", large, small));
        const Region first = diagram.opening(large);
        const Region rest = offset(diagram.restCentres(large, small), small, kTol);
        const Region whole = diagram.opening(small);
        // At a tie a neck may count either way.
        if (area(whole) > area(diagram.opening(small + kTieMm)) + slackOf(which)) return;
        EXPECT_NEAR(area(unite(first, rest, kTol)), area(whole),
                    slackOf(which) + 2 * kTol.linear_mm * perimeter(rest));
        for (int i = 0; i < 16; ++i) {
            const Vec2 p = probePoint(which.region, 0, random);
            if (std::abs(signedClearance(whole, p)) < kTieMm) continue;
            if (std::min(distanceToBoundary(first, p), distanceToBoundary(rest, p)) < kTieMm) continue;
            EXPECT_EQ(contains(first, p) || contains(rest, p), contains(whole, p)) << p.transpose();
        }
    });
}

INSTANTIATE_TEST_SUITE_P(On, OpeningLaws, testing::ValuesIn(kRegionKinds), kindName);

}  // namespace
}  // namespace stepmill::test
