#include "stepmill/planar/indexed_region.h"

#include <gtest/gtest.h>

#include <random>

#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

/// A plate with two holes and a round corner cut off.
Region plate() {
    Region region = makeRectangle({0, 0}, {40, 30});
    for (const Region& hole :
         {makeCircle({12, 15}, 5), makeRectangle({25, 10}, {33, 22}), makeCircle({40, 0}, 8)})
        region = subtract(region, hole, kTol);
    return region;
}

TEST(IndexedRegion, HoldsNothingWithoutEdges) {
    EXPECT_FALSE(IndexedRegion().contains({0, 0}));
    EXPECT_TRUE(IndexedRegion().boundary().empty());
}

TEST(IndexedRegion, AnswersAsContainsDoes) {
    const Region region = plate();
    const IndexedRegion indexed(region);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> x(-2, 42);
    std::uniform_real_distribution<double> y(-2, 32);
    int inside = 0;
    for (int i = 0; i < 5000; ++i) {
        const Vec2 p(x(random), y(random));
        ASSERT_EQ(indexed.contains(p), contains(region, p)) << p.transpose();
        inside += indexed.contains(p) ? 1 : 0;
    }
    EXPECT_GT(inside, 2000);
    EXPECT_LT(inside, 4500);
}

TEST(IndexedRegion, HoldsItsBoundaryAndItsCornersHeights) {
    const Region region = plate();
    const IndexedRegion indexed(region);
    for (const Edge& edge : edgesOf(region))
        for (const double share : {0.0, 0.3, 1.0}) {
            const Vec2 on = pointAt(edge, share);
            EXPECT_TRUE(indexed.contains(on)) << on.transpose();
            // Rays through corners and along edges.
            for (const double off_mm : {-45.0, -3.0, 1.5, 45.0}) {
                const Vec2 beside(on.x() + off_mm, on.y());
                EXPECT_EQ(indexed.contains(beside), contains(region, beside)) << beside.transpose();
            }
        }
}

}  // namespace
}  // namespace stepmill
