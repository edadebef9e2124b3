#include "stepmill/planar/disc_sweep.h"

#include <gtest/gtest.h>

#include "planar/boolean/curve_pairs.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "stepmill/planar/edge.h"
#include "support/dice.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

Path wayThrough(const std::vector<Vec2>& points) {
    Path way{points.front(), {}};
    for (std::size_t i = 1; i < points.size(); ++i)
        way.segments.push_back({points[i], std::nullopt});
    return way;
}

double sweptMm2(const Path& way, double radius_mm) {
    return area(discSweep(way, radius_mm, kTol));
}

TEST(DiscSweep, OfAWayBackOverItselfIsThatOfTheWay) {
    EXPECT_NEAR(sweptMm2(wayThrough({{0, 0}, {10, 0}, {0, 0}, {10, 0}}), 2), 40 + 4 * kPi, 1e-4);
}

TEST(DiscSweep, RoundsTheOutsideOfACornerAndNotItsInside) {
    // Two strips that share a square inside, a quarter of the disc outside, and half of it at both ends.
    const double two_mm2 = 2 * (2 * 2 * 20) + 4 * kPi;
    EXPECT_NEAR(sweptMm2(wayThrough({{0, 0}, {20, 0}, {20, 20}}), 2), two_mm2 - 2 * 2 + kPi, 1e-4);
}

TEST(DiscSweep, HasAHoleWhereTheWayGoesRoundOne) {
    const Region swept = discSweep(wayThrough({{0, 0}, {20, 0}, {20, 20}, {0, 20}, {0, 0}}), 2, kTol);
    EXPECT_EQ(swept.loops.size(), 2U);
    EXPECT_FALSE(contains(swept, {10, 10}));
    EXPECT_NEAR(area(swept), 20 * 4 * 4 - 4 * 4 + 4 * kPi, 1e-4);
}

TEST(DiscSweep, OfAFanOfWaysThroughOnePointHoldsThePoint) {
    std::vector<Vec2> points;
    for (int i = 0; i < 40; ++i) {
        const double rad = kPi * i / 40;
        points.push_back(snapToGrid(Vec2(10 * std::cos(rad), 10 * std::sin(rad))));
        points.push_back(-points.back());
    }
    const Region swept = discSweep(wayThrough(points), 1, kTol);
    EXPECT_TRUE(contains(swept, {0, 0}));
    EXPECT_LT(area(swept), 121 * kPi);
    EXPECT_GT(area(swept), 100 * kPi);
}

TEST(Encircled, LeavesOutWhatIsGoneRoundClockwiseAlone) {
    // A figure of eight.
    const Path eight = wayThrough({{0, 0}, {10, 10}, {10, 0}, {0, 10}, {0, 0}});
    EXPECT_NEAR(area(encircled(eight, kTol)), 25, 1e-6);
    EXPECT_NEAR(area(encircled(reversed(eight), kTol)), 25, 1e-6);
    EXPECT_LT(boundingBox(encircled(eight, kTol)).sizes().x(), 6);
}

TEST(Encircled, CountsOnceWhatIsGoneRoundTwice) {
    const Path twice = wayThrough({{0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}, {8, 0}, {8, 8}, {0, 8}, {0, 0}});
    EXPECT_NEAR(area(encircled(twice, kTol)), 64, 1e-6);
}

TEST(OverlappingBoxes, AreThoseThatComeNear) {
    constexpr double kSlackMm = 0.01;
    for (unsigned seed = 0; seed < 20; ++seed) {
        test::Dice dice(seed);
        const double longest_mm = dice.between(0.5, 60);
        std::vector<planar::Curve> curves;
        for (int i = 0; i < 300; ++i) {
            const Vec2 from = snapToGrid(Vec2(dice.between(0, 100), dice.between(0, 100)));
            const Vec2 by(dice.between(-longest_mm, longest_mm), dice.between(-longest_mm, longest_mm));
            curves.push_back({makeLine(from, snapToGrid(Vec2(from + by))), 0, i});
        }
        std::vector<std::pair<int, int>> expected;
        for (int i = 0; i < 300; ++i)
            for (int j = i + 1; j < 300; ++j)
                if (grown(curves[i].box, kSlackMm).intersects(curves[j].box)) expected.emplace_back(i, j);
        EXPECT_EQ(planar::overlappingBoxes(curves, kSlackMm), expected) << "seed " << seed;
    }
}

}  // namespace
}  // namespace stepmill
