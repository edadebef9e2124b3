// Laws of the offsets of one ClearanceDiagram, on every kind of random region.

#include <gtest/gtest.h>

#include <cmath>

#include <fmt/format.h>

#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/planar/edge.h"
#include "support/diagram_laws.h"

namespace stepmill::test {
namespace {

class OffsetLaws : public DiagramLaws {};

void expectDistances(const Region& region, const Region& result, double distance) {
    const Deviation off = deviation(result, region, distance);
    EXPECT_LT(off.too_close_mm, kTol.gouge_mm) << "gouges at " << off.closest_at.transpose();
    EXPECT_LT(off.too_close_mm, kRoundingMm) << "at " << off.closest_at.transpose();
    // What is added for safety where Booleans are the way out.
    EXPECT_LT(off.too_far_mm, 2 * kRoundingMm) << "at " << off.farthest_at.transpose();
}

TEST_P(OffsetLaws, EveryPointHasTheDistance) {
    forSeeds(250, [](const RandomRegion& which, Random& random) {
        const ClearanceDiagram diagram(which.region, kTol);
        for (int k = 0; k < 6; ++k) {
            const double d = radius(which, diagram, random);
            for (const double distance : {-d, d}) {
                SCOPED_TRACE(fmt::format("offset {:.6f}", distance));
                const Region result = diagram.offset(distance);
                expectDistances(which.region, result, distance);
                const auto trouble = diagnose(result);
                EXPECT_EQ(trouble, std::nullopt);
            }
        }
    });
}

TEST_P(OffsetLaws, NothingIsMissingAndNothingTooMuch) {
    forSeeds(250, [](const RandomRegion& which, Random& random) {
        const ClearanceDiagram diagram(which.region, kTol);
        for (int k = 0; k < 3; ++k) {
            const double d = radius(which, diagram, random);
            for (const double distance : {-d, d}) {
                SCOPED_TRACE(fmt::format("offset {:.6f}", distance));
                const Region result = diagram.offset(distance);
                for (int i = 0; i < 24; ++i) {
                    const Vec2 p = probePoint(which.region, std::max(0.0, distance), random);
                    const double above = signedClearance(which.region, p) + distance;
                    if (std::abs(above) < kTieMm) continue;
                    EXPECT_EQ(contains(result, p), above > 0) << p.transpose() << " is above by " << above;
                }
            }
        }
    });
}

/// Is the arc concentric with an arc of the region at that distance, or about a corner with that radius?
bool isParallel(const Region& region, const Arc& arc, double distance) {
    for (const auto& [from, segment] : eachEdge(region)) {
        if (segment.arc && segment.arc->centre == arc.centre &&
            std::abs(std::abs(segment.arc->radius_mm - arc.radius_mm) - std::abs(distance)) < 1e-9)
            return true;
        if (segment.to == arc.centre && std::abs(arc.radius_mm - std::abs(distance)) < 1e-9) return true;
    }
    return false;
}

/// Do both ends of the line keep the distance from the carrier of one line of the region?
bool isParallel(const Region& region, const Vec2& from, const Vec2& to, double distance) {
    for (const EdgeView wall : eachEdge(region)) {
        if (wall.segment.arc) continue;
        const Vec2 along = (wall.segment.to - wall.from).normalized();
        const auto off = [&](const Vec2& p) {
            return std::abs(cross(along, p - wall.from)) - std::abs(distance);
        };
        if (std::abs(off(from)) < kRoundingMm && std::abs(off(to)) < kRoundingMm) return true;
    }
    return false;
}

TEST_P(OffsetLaws, ArcsStayArcsAndLinesStayLines) {
    forSeeds(60, [](const RandomRegion& which, Random& random) {
        const ClearanceDiagram diagram(which.region, kTol);
        const double d = radius(which, diagram, random);
        const std::size_t edges = edgesOf(which.region).size();
        for (const double distance : {-d, d}) {
            SCOPED_TRACE(fmt::format("offset {:.6f}", distance));
            const Region result = diagram.offset(distance);
            for (const auto& [from, segment] : eachEdge(result)) {
                if (segment.arc) {
                    EXPECT_TRUE(isParallel(which.region, *segment.arc, distance))
                        << segment.arc->centre.transpose();
                } else if ((segment.to - from).norm() >
                           kTieMm) {  // shorter ones join what rounding set apart
                    EXPECT_TRUE(isParallel(which.region, from, segment.to, distance)) << from.transpose();
                }
            }
            EXPECT_LE(edgesOf(result).size(), 3 * edges) << "edges and corners, some of them twice";
        }
        const Region opened = diagram.opening(d);
        for (const auto& [from, segment] : eachEdge(opened)) {
            if (!segment.arc || std::abs(segment.arc->radius_mm - d) < 1e-9) continue;
            EXPECT_TRUE(isParallel(which.region, *segment.arc, 0)) << "walls are the region's own";
        }
    });
}

TEST_P(OffsetLaws, ErosionsAdd) {
    forSeeds(150, [](const RandomRegion& which, Random& random) {
        const double first = which.freeRadius(random) / 2;
        const double second = which.freeRadius(random) / 2;
        SCOPED_TRACE(fmt::format("{:.6f} and {:.6f}", first, second));
        const ClearanceDiagram diagram(which.region, kTol);
        const Region twice = offset(diagram.offset(-first), -second, kTol);
        const Region once = diagram.offset(-(first + second));
        EXPECT_NEAR(area(twice), area(once), kRoundingMm * perimeter(which.region));
        const Deviation off = deviation(twice, which.region, first + second);
        EXPECT_LT(off.too_close_mm, 2 * kRoundingMm) << "at " << off.closest_at.transpose();
    });
}

TEST_P(OffsetLaws, GrowingAfterShrinkingNeverLeavesTheRegion) {
    forSeeds(100, [](const RandomRegion& which, Random& random) {
        const ClearanceDiagram diagram(which.region, kTol);
        const double d = radius(which, diagram, random);
        SCOPED_TRACE(fmt::format("{:.6f}", d));
        const Region back = offset(diagram.offset(-d), d, kTol);
        // At a tie a neck or a room may count either way.
        const double tie = std::min(kTieMm, d / 2);
        const double slack = (kRoundingMm + 2 * tie) * perimeter(which.region);
        const double opened = area(diagram.opening(d));
        EXPECT_GE(opened, area(offset(diagram.offset(-d - tie), d, kTol)) - slack);
        EXPECT_LE(opened, area(offset(diagram.offset(-d + tie), d, kTol)) + slack);
        if (!ties(diagram, -d)) {
            EXPECT_NEAR(area(back), opened, kRoundingMm * perimeter(which.region));
        }
        for (int i = 0; i < 10; ++i) {
            const Vec2 p = probePoint(back, 0, random);
            if (signedClearance(back, p) > kTieMm) {
                EXPECT_TRUE(contains(which.region, p)) << p.transpose();
            }
        }
    });
}

TEST_P(OffsetLaws, GrowthFarBeyondTheSizeIsNearlyADisc) {
    forSeeds(100, [](const RandomRegion& which, Random& random) {
        const double d = snapToGrid(which.size_mm * std::pow(10, random.real(0, 3)));
        SCOPED_TRACE(fmt::format("offset {:.6f}", d));
        const Region result = offset(which.region, d, kTol);
        expectDistances(which.region, result, d);
        EXPECT_EQ(diagnose(result), std::nullopt);
        const Vec2 size = boundingBox(which.region).sizes();
        const double reach = d + size.norm();
        EXPECT_GT(area(result), kPi * d * d * (1 - 1e-9));
        EXPECT_LT(area(result), kPi * reach * reach);
    });
}

/// The measures that must not depend on how a region lies or is written down.
void expectSameOffsets(const RandomRegion& which, const Region& other, Random& random) {
    const ClearanceDiagram diagram(which.region, kTol);
    const ClearanceDiagram moved(other, kTol);
    const double slack = 2 * kRoundingMm * perimeter(which.region);
    for (int k = 0; k < 3; ++k) {
        const double d = which.freeRadius(random);
        SCOPED_TRACE(fmt::format("radius {:.6f}", d));
        if (ties(diagram, -d) || ties(diagram, d)) continue;
        for (const double distance : {d, -d}) {
            const Region a = diagram.offset(distance);
            const Region b = moved.offset(distance);
            EXPECT_EQ(a.loops.size(), b.loops.size()) << distance;
            EXPECT_NEAR(area(a), area(b), slack) << distance;
        }
        EXPECT_NEAR(area(diagram.opening(d)), area(moved.opening(d)), slack);
    }
    // A tie may fall to either side when points move by a nanometre, but no farther.
    const double tie = which.tieRadius(random);
    SCOPED_TRACE(fmt::format("tie {:.6f}", tie));
    const double opened = area(moved.opening(tie));
    EXPECT_LE(opened, area(diagram.opening(std::max(tie / 2, tie - kTieMm))) + slack);
    EXPECT_GE(opened, area(diagram.opening(tie + kTieMm)) - slack);
}

TEST_P(OffsetLaws, PlaceAndQuarterTurnsDoNotMatter) {
    forSeeds(100, [](const RandomRegion& which, Random& random) {
        const Vec2 by = snapToGrid(Vec2(random.real(-300, 300), random.real(-300, 300)));
        expectSameOffsets(which, turned(which.region, random.below(4) * kPi / 2, by), random);
    });
}

TEST_P(OffsetLaws, FreeTurnsDoNotMatter) {
    forSeeds(100, [](const RandomRegion& which, Random& random) {
        const Region other = turned(which.region, random.real(0, 2 * kPi), {0, 0});
        if (!diagnose(other)) expectSameOffsets(which, other, random);
    });
}

TEST_P(OffsetLaws, MirroringDoesNotMatter) {
    forSeeds(60, [](const RandomRegion& which, Random& random) {
        expectSameOffsets(which, mirrored(which.region), random);
    });
}

TEST_P(OffsetLaws, StartVertexAndLoopOrderDoNotMatter) {
    forSeeds(60, [](const RandomRegion& which, Random& random) {
        expectSameOffsets(which, renumbered(which.region, random), random);
    });
}

TEST_P(OffsetLaws, RingsAreTheOffsetsAndNested) {
    forSeeds(60, [](const RandomRegion& which, Random& random) {
        const ClearanceDiagram diagram(which.region, kTol);
        const double step = snapToGrid(which.size_mm / random.real(15, 40));
        double last = area(which.region);
        double distance = step / 2;
        const std::vector<Region> rings = diagram.rings(distance, step);
        for (const Region& ring : rings) {
            expectDistances(which.region, ring, snapToGrid(distance));
            EXPECT_NEAR(area(ring), area(diagram.offset(-distance)), kRoundingMm * perimeter(which.region));
            EXPECT_LT(area(ring), last);
            last = area(ring);
            distance += step;
        }
        EXPECT_TRUE(diagram.offset(-distance).empty());
    });
}

INSTANTIATE_TEST_SUITE_P(On, OffsetLaws, testing::ValuesIn(kRegionKinds), kindName);

}  // namespace
}  // namespace stepmill::test
