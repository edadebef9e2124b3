#include "layers/indexed_region.h"

#include <gtest/gtest.h>

#include <random>

#include "layers/stock/rectangle_union.h"
#include "layers/stock/scanned_area.h"
#include "stepmill/core/units.h"
#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"

using namespace stepmill;
using namespace stepmill::layers;

namespace {

using test::kTol;

/// A plate of 60 x 40 with a round hole and a rounded pocket.
Region plate() {
    const Region holes[] = {makeCircle(Vec2(20, 20), 7), makeRoundedRectangle(Vec2(35, 8), Vec2(52, 31), 3)};
    return subtract(makeRectangle(Vec2(0, 0), Vec2(60, 40)), unite(holes, kTol), kTol);
}

class RandomBoxes {
  public:
    explicit RandomBoxes(unsigned seed) : random_(seed) {}

    Box2 next() {
        const Vec2 low(number(-5, 55), number(-5, 35));
        return {low, low + Vec2(number(1, 15), number(1, 15))};
    }
    double number(double low, double high) { return low + (high - low) * (random_() % 1000) / 1000.0; }

  private:
    std::mt19937 random_;
};

Region rectangle(const Box2& box) {
    return makeRectangle(box.min(), box.max());
}

double areaOf(const std::vector<Box2>& boxes) {
    double area_mm2 = 0;
    for (const Box2& box : boxes)
        area_mm2 += box.sizes().prod();
    return area_mm2;
}

}  // namespace

TEST(IndexedRegion, MeasuresWhatLiesInBoxesAsABooleanDoes) {
    const Region region = plate();
    const IndexedRegion indexed(region);
    RandomBoxes random(1);
    for (int i = 0; i < 200; ++i) {
        const Box2 box = random.next();
        EXPECT_NEAR(indexed.areaIn(box), area(intersect(region, rectangle(box), kTol)), 1e-4)
            << box.min().transpose() << " .. " << box.max().transpose();
    }
}

TEST(IndexedRegion, KnowsInsideFromOutside) {
    const Region region = plate();
    const IndexedRegion indexed(region);
    RandomBoxes random(2);
    for (int i = 0; i < 200; ++i) {
        const Vec2 p = random.next().min();
        if (distanceToBoundary(region, p) < 1e-3) continue;
        EXPECT_EQ(indexed.holds(p), contains(region, p)) << p.transpose();
    }
    EXPECT_TRUE(indexed.isBeyond(Vec2(20, 20), 6.9));
    EXPECT_FALSE(indexed.isBeyond(Vec2(20, 20), 7.1));
    EXPECT_TRUE(indexed.isDeep(Vec2(5, 5), 4.9));
    EXPECT_FALSE(indexed.isDeep(Vec2(5, 5), 5.1));
}

TEST(RectangleUnion, CoversWhatTheBooleanUnionCovers) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        RandomBoxes random(seed);
        std::vector<Box2> boxes;
        std::vector<Region> regions;
        for (int i = 0; i < 25; ++i) {
            boxes.push_back(random.next());
            regions.push_back(rectangle(boxes.back()));
        }
        const RectangleUnion joined(boxes, kTol.linear_mm);
        const Region outline = joined.outline();
        const Region expected = unite(regions, kTol);
        EXPECT_FALSE(diagnose(outline)) << *diagnose(outline);
        EXPECT_NEAR(area(outline), area(expected), 1e-2);
        EXPECT_NEAR(areaOf(joined.apart()), area(expected), 1e-2);
        EXPECT_NEAR(area(subtract(outline, expected, kTol)), 0, 1e-2);
    }
}

TEST(RectangleUnion, MakesTwoLoopsOfCornersThatTouch) {
    const std::vector<Box2> boxes = {{Vec2(0, 0), Vec2(10, 10)}, {Vec2(10, 10), Vec2(20, 20)}};
    const Region outline = RectangleUnion(boxes, kTol.linear_mm).outline();
    EXPECT_EQ(outline.loops.size(), 2u);
    EXPECT_NEAR(area(outline), 200, 1e-9);
}

TEST(RectangleUnion, IsEmptyWithoutRectangles) {
    EXPECT_TRUE(RectangleUnion({}, kTol.linear_mm).outline().empty());
    EXPECT_TRUE(RectangleUnion({}, kTol.linear_mm).apart().empty());
}

TEST(ScannedArea, IsWhatPolygonsCoverTogetherToAThousandth) {
    const Region region = plate();
    const IndexedRegion within(region);
    for (unsigned seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE(seed);
        RandomBoxes random(seed);
        std::vector<BandedPolygon> polygons;
        std::vector<Region> regions;
        for (int i = 0; i < 6; ++i) {
            const Box2 box = random.next();
            const Vec2 lean(random.number(-4, 4), random.number(-4, 4));
            regions.push_back(makePolygon({box.min(), Vec2(box.max().x(), box.min().y()) + lean / 4,
                                           box.max() + lean, Vec2(box.min().x(), box.max().y())}));
            polygons.push_back(banded(regions.back()));
        }
        const double expected = area(intersect(region, unite(regions, kTol), kTol));
        EXPECT_NEAR(scannedArea(within, polygons), expected, 1e-3 * area(region));
    }
}

TEST(ScannedArea, KeepsToTheBand) {
    const IndexedRegion within(makeRectangle(Vec2(0, 0), Vec2(60, 40)));
    BandedPolygon polygon = banded(Box2(Vec2(10, 10), Vec2(50, 30)));
    polygon.across = Vec2(1, 0);
    polygon.low = 20;
    polygon.high = 45;
    EXPECT_NEAR(scannedArea(within, {polygon}), 25 * 20, 1e-6);
    polygon.across = Vec2(0, 1);
    EXPECT_NEAR(scannedArea(within, {polygon}), 40 * 10, 1e-6);
}
