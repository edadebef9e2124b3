#include <gtest/gtest.h>

#include "stack_maker.h"
#include "stepmill/feature/feature.h"
#include "stepmill/feature/reason.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::makeStack;

using test::kTol;
const Region kBlock = makeRectangle({0, 0}, {100, 80});

/// The block around a rectangular room.
Region around(double x0, double y0, double x1, double y1) {
    return subtract(kBlock, makeRectangle({x0, y0}, {x1, y1}), kTol);
}

/// The same levels of a part without a horizontal face between them.
LayerStack leaning(LayerStack stack) {
    stack.traces.clear();
    return stack;
}

/// A pocket whose walls lean: three levels, each smaller, over a floor.
LayerStack leaningPocket() {
    return leaning(makeStack(kBlock, {{-5, around(10, 10, 90, 70)},
                                      {-12, around(12, 12, 88, 68)},
                                      {-20, around(14, 14, 86, 66)},
                                      {-30, kBlock}}));
}

std::vector<std::string> idsOf(const FeatureSet& found) {
    std::vector<std::string> ids;
    for (const Feature& feature : found.features)
        ids.push_back(feature.id);
    return ids;
}

TEST(JoinBands, LevelsOfAWallThatLeansAreBandsOfOneFeature) {
    const FeatureSet found = recogniseFeatures(leaningPocket(), kTol);
    EXPECT_EQ(idsOf(found), (std::vector<std::string>{"S1.F1.1", "S1.F1.2", "S1.F1.3"}));
    EXPECT_EQ(found.features[2].parents, std::vector<std::string>{"S1.F1.2"});
    EXPECT_EQ(found.features[1].band->of, "S1.F1");
    EXPECT_EQ(found.features[1].band->number, 2);
    EXPECT_EQ(found.features[1].band->count, 3);
}

TEST(JoinBands, AFaceOfThePartEndsAFeature) {
    LayerStack stack = leaningPocket();
    stack.traces.push_back(test::floorFace(
        -12, subtract(makeRectangle({12, 12}, {88, 68}), makeRectangle({14, 14}, {86, 66}), kTol)));
    EXPECT_EQ(idsOf(recogniseFeatures(stack, kTol)),
              (std::vector<std::string>{"S1.F1.1", "S1.F1.2", "S1.F2"}));
}

TEST(JoinBands, WhereItSplitsAFeatureGoesOnInTheLargestPiece) {
    const LayerStack stack = leaning(
        makeStack(kBlock, {{-5, around(10, 10, 90, 70)},
                           {-12, subtract(around(12, 12, 40, 68), makeRectangle({50, 12}, {88, 68}), kTol)},
                           {-30, kBlock}}));
    const FeatureSet found = recogniseFeatures(stack, kTol);
    ASSERT_EQ(found.features.size(), 3U);
    for (const Feature& feature : found.features)
        EXPECT_EQ(feature.band.has_value(), feature.area_mm2 > 28 * 56 + 1) << feature.id;
}

TEST(JoinBands, AnUprightHoleInAFloorThatLeansIsAFeatureOfItsOwn) {
    const Region hole = makeCircle({50, 40}, 5);
    LayerStack stack = makeStack(kBlock, {{-5, around(10, 10, 90, 70)}, {-25, subtract(kBlock, hole, kTol)}});
    FaceTrace wall;
    wall.stand = FaceStand::Wall;
    wall.top_z_mm = -5;
    wall.bottom_z_mm = -25;
    wall.footprint = hole.loops.front();
    stack.traces.push_back(wall);
    EXPECT_EQ(idsOf(recogniseFeatures(stack, kTol)), (std::vector<std::string>{"S1.F1", "S1.F2"}));
    stack.traces.clear();
    EXPECT_EQ(idsOf(recogniseFeatures(stack, kTol)), (std::vector<std::string>{"S1.F1.1", "S1.F1.2"}))
        << "no wall stands upright: a funnel";
}

}  // namespace
}  // namespace stepmill
