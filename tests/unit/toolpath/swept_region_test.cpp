#include "stepmill/toolpath/swept_region.h"

#include <random>

#include <gtest/gtest.h>

#include "stepmill/core/units.h"
#include "support/tolerances.h"

namespace stepmill::toolpath {
namespace {

using test::kTol;

TEST(SweptRegion, OfAStandIsADisc) {
    EXPECT_NEAR(area(sweptRegion({{Vec2(3, 4), {}}}, 2, kTol)), 4 * kPi, 1e-6);
}

TEST(SweptRegion, OfALineIsAStadium) {
    EXPECT_NEAR(area(sweptRegion({{Vec2(0, 0), {{Vec2(10, 0), {}}}}}, 2, kTol)), 40 + 4 * kPi, 1e-5);
}

TEST(SweptRegion, OfACircleIsARing) {
    const Path circle{Vec2(5, 0), {{Vec2(5, 0), Arc{Vec2(0, 0), 5, true}}}};
    const Region swept = sweptRegion({circle}, 2, kTol);
    EXPECT_NEAR(area(swept), kPi * (49 - 9), 1e-5);
    EXPECT_EQ(swept.loops.size(), 2U);
}

TEST(SweptRegion, OfACircleNarrowerThanTheDiscHasNoHole) {
    const Path circle{Vec2(1, 0), {{Vec2(1, 0), Arc{Vec2(0, 0), 1, false}}}};
    const Region swept = sweptRegion({circle}, 2, kTol);
    EXPECT_NEAR(area(swept), kPi * 9, 1e-5);
    EXPECT_EQ(swept.loops.size(), 1U);
}

/// A wandering chain of lines and arcs, longer or much shorter than discs are wide.
Path randomWay(std::mt19937& random) {
    const auto uniform = [&](double a, double b) { return std::uniform_real_distribution(a, b)(random); };
    Path way{snapToGrid(Vec2(uniform(0, 50), uniform(0, 50))), {}};
    const bool is_fine = uniform(0, 1) < 0.3;
    const double step_mm = is_fine ? 0.8 : 15;
    const int edges = std::uniform_int_distribution(1, is_fine ? 60 : 12)(random);
    for (int i = 0; i < edges; ++i) {
        const Vec2 from = way.end();
        const Vec2 to = snapToGrid(Vec2(from + Vec2(uniform(-step_mm, step_mm), uniform(-step_mm, step_mm))));
        if (uniform(0, 1) < 0.5) {
            way.segments.push_back({to, std::nullopt});
            continue;
        }
        const Vec2 half = (to - from) / 2;
        const Vec2 centre = from + half + uniform(-1, 1) * leftOf(half);
        way.segments.push_back({to, Arc{centre, (from - centre).norm(), uniform(0, 1) < 0.5}});
    }
    return way;
}

double distanceTo(const std::vector<Path>& ways, const Vec2& p) {
    double least = 1e9;
    for (const Path& way : ways)
        least = std::min(least, stepmill::distanceTo(p, way));
    return least;
}

TEST(SweptRegion, HoldsExactlyThePointsWithinTheRadius) {
    for (unsigned seed = 0; seed < 100; ++seed) {
        std::mt19937 random(seed);
        const std::vector<Path> ways{randomWay(random), randomWay(random)};
        const double radius = std::uniform_real_distribution(0.3, 6.0)(random);
        const Region swept = sweptRegion(ways, radius, kTol);
        std::uniform_real_distribution<double> place(-20, 70);
        for (int i = 0; i < 300; ++i) {
            const Vec2 p(place(random), place(random));
            const double distance = distanceTo(ways, p);
            if (std::abs(distance - radius) < 1e-3) continue;
            EXPECT_EQ(contains(swept, p), distance < radius)
                << "seed " << seed << " at " << p.transpose() << ", " << distance << " of " << radius;
        }
    }
}

}  // namespace
}  // namespace stepmill::toolpath
