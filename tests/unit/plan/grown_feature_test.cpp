#include <gtest/gtest.h>

#include "stepmill/plan/grown_feature.h"
#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;
const Region kBlock = makeRectangle(Vec2(0, 0), Vec2(100, 60));

/// Half a millimetre on every side of a block of 100 x 60.
StockGrowth growth(double top_mm = 0.5) {
    return {0.5, top_mm, Box2(Vec2(0, 0), Vec2(100, 60))};
}

/// A slot of 20 mm from the block's right side in, 10 mm deep; material stands on both sides of it.
Feature slot(double top_z_mm = 0) {
    Feature feature;
    feature.target = makeRectangle(Vec2(40, 20), Vec2(100, 40));
    feature.obstruction = subtract(kBlock, feature.target, kTol);
    feature.top_z_mm = top_z_mm;
    feature.floor_z_mm = top_z_mm - 10;
    feature.area_mm2 = area(feature.target);
    feature.volume_mm3 = feature.area_mm2 * feature.depth_mm();
    feature.obstacles = {{feature.floor_z_mm, top_z_mm, feature.obstruction}};
    feature.open_length_mm = 20;
    return feature;
}

TEST(OnGrownStock, IsTheFeatureWhereNothingGrows) {
    const Feature same = onGrownStock(slot(), {}, kTol);
    EXPECT_DOUBLE_EQ(same.area_mm2, slot().area_mm2);
    EXPECT_TRUE(same.skirt.empty());
}

TEST(OnGrownStock, GoesOnOverOpenEdgesAsFarAsTheStockMay) {
    const Feature grown = onGrownStock(slot(), growth(), kTol);
    EXPECT_TRUE(contains(grown.target, Vec2(100.49, 30)));
    EXPECT_FALSE(contains(grown.target, Vec2(100.51, 30)));
    EXPECT_FALSE(contains(grown.target, Vec2(39.9, 30))) << "a wall is no open edge";
    EXPECT_DOUBLE_EQ(grown.area_mm2, area(grown.target));
    EXPECT_TRUE(area(intersect(grown.target, slot().obstruction, kTol)) < kTol.area_mm2);
}

TEST(OnGrownStock, GoesStraightOutAndIntoCorners) {
    const Feature through = onGrownStock(slot(), growth(), kTol);
    EXPECT_FALSE(contains(through.target, Vec2(100.25, 19.99))) << "before the wall beside it";
    EXPECT_TRUE(contains(through.skirt, Vec2(100.25, 19.99)));
    Feature step = slot();
    step.target = makeRectangle(Vec2(40, 20), Vec2(100, 60));
    step.obstruction = subtract(kBlock, step.target, kTol);
    const Feature corner = onGrownStock(step, growth(), kTol);
    EXPECT_TRUE(contains(corner.target, Vec2(100.4, 60.4)));
    EXPECT_TRUE(contains(corner.target, Vec2(70, 60.4)));
    EXPECT_NEAR(corner.area_mm2, 60.5 * 40.5, 1e-3);
}

TEST(OnGrownStock, HasASkirtBesideWhatMustStay) {
    const Feature grown = onGrownStock(slot(), growth(), kTol);
    EXPECT_TRUE(contains(grown.skirt, Vec2(100.25, 10)));
    EXPECT_TRUE(contains(grown.skirt, Vec2(-0.25, 30)));
    EXPECT_TRUE(contains(grown.skirt, Vec2(100.4, 60.4))) << "the corner of a box that is larger all round";
    EXPECT_FALSE(contains(grown.skirt, Vec2(100.25, 30))) << "that is target";
}

TEST(OnGrownStock, LeavesAirBesideGroundThatIsGone) {
    Feature step = slot();
    step.obstruction = makeRectangle(Vec2(0, 0), Vec2(40, 60));
    EXPECT_FALSE(contains(onGrownStock(step, growth(), kTol).skirt, Vec2(100.25, 10)));
}

TEST(OnGrownStock, RaisesARawTopAlone) {
    const Feature grown = onGrownStock(slot(), growth(), kTol);
    EXPECT_DOUBLE_EQ(grown.top_z_mm, 0.5);
    EXPECT_DOUBLE_EQ(grown.obstacles.back().top_z_mm, 0.5);
    EXPECT_DOUBLE_EQ(grown.volume_mm3, grown.area_mm2 * 10.5);
    EXPECT_DOUBLE_EQ(onGrownStock(slot(-3), growth(), kTol).top_z_mm, -3);
    EXPECT_DOUBLE_EQ(onGrownStock(slot(), growth(0), kTol).top_z_mm, 0);
}

TEST(OnGrownStock, LetsObstaclesStandOutFarther) {
    const Feature grown = onGrownStock(slot(), growth(), kTol);
    EXPECT_TRUE(contains(grown.obstacles.front().section, Vec2(100.25, 10)));
    EXPECT_FALSE(contains(grown.obstruction, Vec2(100.25, 10))) << "cutters may cut it";
}

TEST(OnGrownStock, WithLeaningSidesIsBesideAllThatStands) {
    StockGrowth all{0.5, 0.5, std::nullopt};
    const Feature grown = onGrownStock(slot(), all, kTol);
    EXPECT_TRUE(contains(grown.target, Vec2(100.25, 30)));
    EXPECT_TRUE(contains(grown.skirt, Vec2(100.25, 10)));
    EXPECT_TRUE(area(intersect(grown.target, slot().obstruction, kTol)) < kTol.area_mm2);
}

TEST(OnGrownStock, LeavesJawsWhereTheyStand) {
    Feature held = slot();
    const Region jaw = makeRectangle(Vec2(100, 25), Vec2(140, 60));
    held.obstruction = unite(held.obstruction, jaw, kTol);
    const Feature grown = onGrownStock(held, growth(), kTol);
    EXPECT_TRUE(contains(grown.target, Vec2(100.25, 22)));
    EXPECT_FALSE(contains(grown.target, Vec2(100.25, 30)));
}

Residual whole(const Feature& feature) {
    Residual residual;
    residual.region = feature.target;
    residual.area_mm2 = feature.area_mm2;
    residual.volume_mm3 = feature.volume_mm3;
    return residual;
}

TEST(OnNominalStock, GivesBackWhatTheStockHasTooMuchOf) {
    const Feature grown = onGrownStock(slot(), growth(), kTol);
    const std::vector<Residual> left = onNominalStock({whole(grown)}, slot(), grown, kTol);
    ASSERT_EQ(left.size(), 1U);
    EXPECT_NEAR(left.front().area_mm2, slot().area_mm2, 1e-2);
    EXPECT_NEAR(left.front().volume_mm3, left.front().area_mm2 * 10, 1e-6);
}

TEST(OnNominalStock, KeepsTheHeightOfWhatStandsLower) {
    const Feature grown = onGrownStock(slot(), growth(), kTol);
    Residual below = whole(grown);
    below.volume_mm3 = below.area_mm2 * 4;
    const std::vector<Residual> left = onNominalStock({below}, slot(), grown, kTol);
    ASSERT_EQ(left.size(), 1U);
    EXPECT_NEAR(left.front().volume_mm3, left.front().area_mm2 * 4, 1e-6);
}

TEST(OnNominalStock, ForgetsWhatLiesOutsideTheStockAlone) {
    const Feature grown = onGrownStock(slot(), growth(), kTol);
    Residual outside = whole(grown);
    outside.region = makeRectangle(Vec2(100.1, 25), Vec2(100.4, 30));
    outside.area_mm2 = area(outside.region);
    EXPECT_TRUE(onNominalStock({outside}, slot(), grown, kTol).empty());
}

}  // namespace
}  // namespace stepmill
