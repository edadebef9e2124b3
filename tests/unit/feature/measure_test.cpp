#include <gtest/gtest.h>

#include "stack_maker.h"
#include "stepmill/feature/measure.h"
#include "stepmill/planar/boolean.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::makeStack;

using test::kTol;
const Region kBlock = makeRectangle({0, 0}, {100, 80});

FeatureMeasures measure(const LayerStack& stack, const Feature& feature) {
    return measureFeature(feature, stack, {}, Eigen::Isometry3d::Identity(), kTol);
}

TEST(MeasureFeature, TellsWidthDepthToWidthAndCorners) {
    const Region pocket = makeRoundedRectangle({20, 20}, {80, 40}, 4);
    const LayerStack stack = makeStack(kBlock, {{-30, subtract(kBlock, pocket, kTol)}, {-40, kBlock}});
    const FeatureSet found = recogniseFeatures(stack, kTol);
    ASSERT_EQ(found.features.size(), 1U);
    const FeatureMeasures measures = measure(stack, found.features[0]);
    EXPECT_NEAR(measures.width_mm, 20, 1e-3);
    EXPECT_NEAR(measures.depth_to_width, 1.5, 1e-3);
    EXPECT_FALSE(measures.sharp_corner);
    ASSERT_EQ(measures.corner_radii_mm.size(), 1U);
    EXPECT_NEAR(measures.corner_radii_mm[0], 4, 1e-6);
}

TEST(MeasureFeature, FindsTheThinWallBetweenTwoPockets) {
    const Region pockets =
        unite(makeRectangle({10, 10}, {49.8, 70}), makeRectangle({50.2, 10}, {90, 70}), kTol);
    const LayerStack stack = makeStack(kBlock, {{-12, subtract(kBlock, pockets, kTol)}, {-40, kBlock}});
    const FeatureSet found = recogniseFeatures(stack, kTol);
    ASSERT_EQ(found.features.size(), 2U);
    for (const Feature& feature : found.features) {
        const FeatureMeasures measures = measure(stack, feature);
        ASSERT_TRUE(measures.wall);
        EXPECT_NEAR(measures.wall->thickness_mm, 0.4, 1e-3);
        EXPECT_NEAR(measures.wall->height_mm, 12, 1e-9);
        EXPECT_TRUE(measures.wall->thin);
    }
}

TEST(MeasureFeature, AThickWallIsNotThin) {
    const Region pocket = makeRectangle({10, 10}, {90, 70});
    const LayerStack stack = makeStack(kBlock, {{-12, subtract(kBlock, pocket, kTol)}, {-40, kBlock}});
    const FeatureMeasures measures = measure(stack, recogniseFeatures(stack, kTol).features.at(0));
    ASSERT_TRUE(measures.wall);
    EXPECT_NEAR(measures.wall->thickness_mm, 10, 1e-3);
    EXPECT_FALSE(measures.wall->thin);
    EXPECT_TRUE(measures.sharp_corner);
}

TEST(MeasureFeature, FindsTheNeckBetweenTwoRooms) {
    const Region rooms =
        unite(unite(makeRectangle({10, 10}, {40, 70}), makeRectangle({60, 10}, {90, 70}), kTol),
              makeRectangle({30, 37}, {70, 43}), kTol);
    const LayerStack stack = makeStack(kBlock, {{-12, subtract(kBlock, rooms, kTol)}, {-40, kBlock}});
    const FeatureMeasures measures = measure(stack, recogniseFeatures(stack, kTol).features.at(0));
    ASSERT_FALSE(measures.necks.empty());
    EXPECT_NEAR(measures.necks.front().width_mm, 6, 1e-3);
}

TEST(NameEngravings, NarrowSlotsWithAFloorAreEngravingsWhereNoCutterIsThatSmall) {
    const Region groove = makeRectangle({20, 20}, {80, 20.8});
    const LayerStack stack = makeStack(kBlock, {{-0.5, subtract(kBlock, groove, kTol)}, {-40, kBlock}});
    FeatureSet found = recogniseFeatures(stack, kTol);
    nameEngravings(found, 0.8, kTol);
    EXPECT_EQ(found.features.at(0).feature_class, FeatureClass::ClosedPocket);
    nameEngravings(found, 1, kTol);
    EXPECT_EQ(found.features.at(0).feature_class, FeatureClass::Engraving);
}

}  // namespace
}  // namespace stepmill
