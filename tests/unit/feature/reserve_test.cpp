#include "stepmill/layers/reserve.h"

#include <gtest/gtest.h>

#include "stack_maker.h"
#include "stepmill/feature/feature.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;
const Region kStock = makeRectangle(Vec2(0, 0), Vec2(100, 60));
const Region kBoss = makeRectangle(Vec2(30, 20), Vec2(70, 40));
/// Left of the boss, as far as the stock goes.
const Region kLeft = makeRectangle(Vec2(0, 0), Vec2(20, 60));

/// A boss 40 high on all of the stock's height: the setup cuts a ring around it.
LayerStack boss() {
    return test::makeStack(kStock, {{-15, kBoss}, {-40, kBoss}});
}

double volumeOf(const FeatureSet& found, Reason reason) {
    double sum_mm3 = 0;
    for (const Unplanned& entry : found.unplanned)
        if (entry.reason == reason) sum_mm3 += entry.volume_mm3;
    return sum_mm3;
}

double featureVolume(const FeatureSet& found) {
    double sum_mm3 = 0;
    for (const Feature& feature : found.features)
        sum_mm3 += feature.volume_mm3;
    return sum_mm3;
}

TEST(Reserve, PartsLayersAtItsEnds) {
    const LayerStack stack = withReserve(boss(), {{kLeft, -5, -40}}, kTol);
    ASSERT_EQ(stack.layers.size(), 3U);
    EXPECT_DOUBLE_EQ(stack.layers[0].bottom_z_mm, -5);
    EXPECT_DOUBLE_EQ(stack.layers[1].bottom_z_mm, -15);
    EXPECT_NEAR(area(stack.layers[0].shadow), area(kBoss), 1e-6);
    EXPECT_NEAR(area(stack.layers[1].shadow), area(kBoss) + area(kLeft), 1e-6);
}

TEST(Reserve, AHoleOverItIsBlind) {
    const Region hole = makeCircle(Vec2(10, 30), 3);
    const Region plate = subtract(kStock, hole, kTol);
    const LayerStack stack = test::makeStack(kStock, {{-40, plate}});
    const FeatureSet whole = recogniseFeatures(stack, kTol);
    ASSERT_EQ(whole.features.size(), 1U);
    EXPECT_TRUE(whole.features.front().through);
    const FeatureSet over = recogniseFeatures(withReserve(stack, {{hole, -30, -40}}, kTol), kTol);
    ASSERT_EQ(over.features.size(), 1U);
    EXPECT_EQ(over.features.front().feature_class, FeatureClass::HoleBlind);
    EXPECT_FALSE(over.features.front().room_below_mm);
}

TEST(Reserve, PartsNothingWhereALevelIs) {
    EXPECT_EQ(withReserve(boss(), {{kLeft, -15 + 1e-6, -40}}, kTol).layers.size(), 2U);
    EXPECT_EQ(withReserve(boss(), {}, kTol).layers.size(), 2U);
}

TEST(Reserve, SharesOutWhatLeaningWallsHide) {
    LayerStack stack = boss();
    stack.layers[1].sloped_volume_mm3 = 50;
    stack.layers[1].hidden = {{SlopeCause::Draft, 50, {}}};
    const LayerStack parted = partedAt(std::move(stack), {-20});
    ASSERT_EQ(parted.layers.size(), 3U);
    EXPECT_NEAR(parted.layers[1].sloped_volume_mm3, 10, 1e-9);
    EXPECT_NEAR(parted.layers[2].hidden.front().volume_mm3, 40, 1e-9);
}

TEST(Reserve, StandsAsTheFloorOfWhatIsCutOverIt) {
    const FeatureSet found = recogniseFeatures(withReserve(boss(), {{kLeft, -15, -40}}, kTol), kTol);
    ASSERT_EQ(found.features.size(), 2U);
    EXPECT_DOUBLE_EQ(found.features[0].floor_z_mm, -15);
    EXPECT_NEAR(found.features[0].area_mm2, area(kStock) - area(kBoss), 1e-6);
    EXPECT_FALSE(found.features[0].through);
    EXPECT_NEAR(found.features[1].area_mm2, area(kStock) - area(kBoss) - area(kLeft), 1e-6);
}

TEST(Reserve, IsAnObstacleToHolders) {
    const FeatureSet found = recogniseFeatures(withReserve(boss(), {{kLeft, 0, -40}}, kTol), kTol);
    ASSERT_EQ(found.features.size(), 1U);
    ASSERT_FALSE(found.features[0].obstacles.empty());
    EXPECT_NEAR(area(found.features[0].obstacles.front().section), area(kBoss) + area(kLeft), 1e-6);
}

TEST(Reserve, IsInTheBooks) {
    const LayerStack whole = boss();
    const FeatureSet found = recogniseFeatures(withReserve(whole, {{kLeft, -15, -40}}, kTol), kTol);
    EXPECT_NEAR(volumeOf(found, Reason::Undercut), area(kLeft) * 25, 1e-6);
    EXPECT_NEAR(featureVolume(found) + volumeOf(found, Reason::Undercut),
                whole.stock_volume_mm3 - whole.part_volume_mm3, 1e-6);
}

TEST(Reserve, HidesWhatLiesUnderIt) {
    // Nothing is lost where a reserve ends over ground that a tool from above can then not reach.
    const LayerStack whole = boss();
    const FeatureSet found = recogniseFeatures(withReserve(whole, {{kLeft, 0, -15}}, kTol), kTol);
    EXPECT_NEAR(volumeOf(found, Reason::Undercut), area(kLeft) * 40, 1e-6);
    EXPECT_NEAR(featureVolume(found) + volumeOf(found, Reason::Undercut),
                whole.stock_volume_mm3 - whole.part_volume_mm3, 1e-6);
}

}  // namespace
}  // namespace stepmill
