
#include <gtest/gtest.h>

#include "stack_maker.h"
#include "stepmill/core/units.h"
#include "stepmill/feature/feature.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::makeStack;

using test::kTol;
const Region kBlock = makeRectangle({0, 0}, {100, 80});

Region rect(double x0, double y0, double x1, double y1) {
    return makeRectangle({x0, y0}, {x1, y1});
}

Region without(const Region& from, const Region& hole) {
    return subtract(from, hole, kTol);
}

double ownedVolume(const FeatureSet& set) {
    double volume = 0;
    for (const Feature& feature : set.features)
        volume += feature.volume_mm3;
    for (const Unplanned& rest : set.unplanned)
        volume += rest.volume_mm3;
    return volume;
}

void expectBooksClose(const LayerStack& stack, const FeatureSet& set) {
    const double removable = stack.stock_volume_mm3 - stack.part_volume_mm3;
    EXPECT_NEAR(ownedVolume(set), removable, 1e-6 * removable);
}

/// The only feature of a block with `part` down to z = -10 over a solid base.
Feature onlyFeature(const Region& part, bool with_base = true) {
    std::vector<test::Slab> slabs{{-10, part}};
    if (with_base) slabs.push_back({-30, kBlock});
    const LayerStack stack = makeStack(kBlock, slabs);
    const FeatureSet set = recogniseFeatures(stack, kTol);
    EXPECT_EQ(set.features.size(), 1U);
    expectBooksClose(stack, set);
    return set.features.front();
}

TEST(RecogniseFeatures, FindsTheRoundedPocketWithItsIsland) {
    const Region pocket = without(makeRoundedRectangle({15, 15}, {85, 65}, 6), makeCircle({50, 40}, 8));
    const Feature feature = onlyFeature(without(kBlock, pocket));
    EXPECT_EQ(feature.id, "S1.F1");
    EXPECT_EQ(feature.feature_class, FeatureClass::ClosedPocket);
    EXPECT_TRUE(feature.parents.empty());
    EXPECT_DOUBLE_EQ(feature.top_z_mm, 0);
    EXPECT_DOUBLE_EQ(feature.floor_z_mm, -10);
    EXPECT_FALSE(feature.through);
    EXPECT_NEAR(feature.area_mm2, 70 * 50 - (4 - kPi) * 36 - kPi * 64, 1e-3);
    EXPECT_NEAR(feature.volume_mm3, 10 * feature.area_mm2, 1e-9 * feature.volume_mm3);
    EXPECT_NEAR(feature.closed_length_mm, 2 * (58 + 38) + 2 * kPi * 6 + 2 * kPi * 8, 1e-3);
    EXPECT_DOUBLE_EQ(feature.open_length_mm, 0);
    ASSERT_TRUE(feature.min_corner_radius_mm);
    EXPECT_NEAR(*feature.min_corner_radius_mm, 6, 1e-6);
}

TEST(RecogniseFeatures, HasNoCornerRadiusWhereACornerIsSharp) {
    const Feature feature = onlyFeature(without(kBlock, rect(15, 15, 85, 65)));
    EXPECT_EQ(feature.feature_class, FeatureClass::ClosedPocket);
    EXPECT_FALSE(feature.min_corner_radius_mm);
}

TEST(RecogniseFeatures, DeepensAComponentThatDoesNotChange) {
    const Region part = without(kBlock, makeRoundedRectangle({15, 15}, {85, 65}, 6));
    const LayerStack stack = makeStack(kBlock, {{-4, part}, {-9, part}, {-10, part}, {-30, kBlock}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    ASSERT_EQ(set.features.size(), 1U);
    EXPECT_DOUBLE_EQ(set.features[0].depth_mm(), 10);
    expectBooksClose(stack, set);
}

TEST(RecogniseFeatures, NestsThreePockets) {
    const LayerStack stack =
        makeStack(kBlock, {{-5, without(kBlock, makeRoundedRectangle({5, 5}, {95, 75}, 8))},
                           {-12, without(kBlock, makeRoundedRectangle({20, 15}, {80, 65}, 6))},
                           {-20, without(kBlock, makeCircle({50, 40}, 15))},
                           {-30, kBlock}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    ASSERT_EQ(set.features.size(), 3U);
    EXPECT_EQ(set.features[1].parents, std::vector<std::string>{"S1.F1"});
    EXPECT_EQ(set.features[2].parents, std::vector<std::string>{"S1.F2"});
    EXPECT_DOUBLE_EQ(set.features[2].top_z_mm, -12);
    EXPECT_EQ(set.features[2].feature_class, FeatureClass::HoleBlind);
    EXPECT_TRUE(set.unplanned.empty());
    expectBooksClose(stack, set);
}

TEST(RecogniseFeatures, EndsAFeatureWhereItSplitsAndMakesEachPieceItsChild) {
    const Region upper = without(kBlock, rect(10, 10, 90, 70));
    const Region lower = without(without(kBlock, rect(10, 10, 45, 70)), rect(55, 10, 90, 70));
    const LayerStack stack = makeStack(kBlock, {{-5, upper}, {-12, lower}, {-30, kBlock}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    ASSERT_EQ(set.features.size(), 3U);
    EXPECT_DOUBLE_EQ(set.features[0].floor_z_mm, -5);
    for (const int child : {1, 2}) {
        EXPECT_EQ(set.features[child].parents, std::vector<std::string>{"S1.F1"});
        EXPECT_NEAR(set.features[child].area_mm2, 35 * 60, 1e-3);
    }
    EXPECT_LT(boundingBox(set.features[1].target).min().x(), boundingBox(set.features[2].target).min().x());
    expectBooksClose(stack, set);
}

TEST(RecogniseFeatures, FacesTheTopOfTheStock) {
    const LayerStack stack = makeStack(kBlock, {{-2, {}}, {-30, kBlock}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    ASSERT_EQ(set.features.size(), 1U);
    EXPECT_EQ(set.features[0].feature_class, FeatureClass::Face);
    EXPECT_DOUBLE_EQ(set.features[0].closed_length_mm, 0);
    EXPECT_NEAR(set.features[0].open_length_mm, 360, 1e-6);
    EXPECT_TRUE(set.features[0].obstruction.empty());
    EXPECT_TRUE(set.features[0].obstacles.empty());
}

TEST(RecogniseFeatures, TellsAStepFromASlotAndAnOpenPocket) {
    EXPECT_EQ(onlyFeature(rect(0, 20, 100, 80)).feature_class, FeatureClass::Step);
    EXPECT_EQ(onlyFeature(without(kBlock, rect(0, 30, 100, 50))).feature_class, FeatureClass::SlotThrough);
    EXPECT_EQ(onlyFeature(without(kBlock, rect(40, 30, 100, 50))).feature_class, FeatureClass::SlotBlind);
    EXPECT_EQ(onlyFeature(without(kBlock, rect(60, 50, 100, 80))).feature_class, FeatureClass::OpenPocket);
    EXPECT_EQ(onlyFeature(rect(30, 30, 50, 50)).feature_class, FeatureClass::OpenPocket);
}

TEST(RecogniseFeatures, CallsASlotWithARoundEndBlind) {
    const Region round_end = unite(rect(40, 30, 100, 50), makeCircle({40, 40}, 10), kTol);
    const Feature feature = onlyFeature(without(kBlock, round_end));
    EXPECT_EQ(feature.feature_class, FeatureClass::SlotBlind);
    EXPECT_NEAR(feature.open_length_mm, 20, 1e-3);
    EXPECT_NEAR(feature.closed_length_mm, 2 * 60 + kPi * 10, 1e-3);
    ASSERT_TRUE(feature.min_corner_radius_mm);
    EXPECT_NEAR(*feature.min_corner_radius_mm, 10, 1e-6);
}

TEST(RecogniseFeatures, TellsWhatGoesThrough) {
    EXPECT_EQ(onlyFeature(without(kBlock, makeCircle({50, 40}, 5)), false).feature_class,
              FeatureClass::HoleThrough);
    EXPECT_EQ(onlyFeature(without(kBlock, rect(40, 30, 60, 50)), false).feature_class,
              FeatureClass::ThroughPocket);
    EXPECT_EQ(onlyFeature(rect(10, 10, 90, 70), false).feature_class, FeatureClass::OpenProfile);
    EXPECT_TRUE(onlyFeature(rect(10, 10, 90, 70), false).through);
}

TEST(RecogniseFeatures, ListsTheBoundaryInLoopOrderWithoutGaps) {
    const Feature feature = onlyFeature(without(kBlock, rect(0, 30, 100, 50)));
    ASSERT_EQ(feature.boundary.size(), 4U);
    for (std::size_t i = 0; i < 4; ++i) {
        const BoundaryPiece& next = feature.boundary[(i + 1) % 4];
        EXPECT_NE(feature.boundary[i].open, next.open);
        EXPECT_EQ(feature.boundary[i].path.end(), next.path.start);
    }
}

TEST(RecogniseFeatures, ReportsUndercutsThatTheToolCannotSee) {
    // A table on a column: the room under its rim is hidden from above.
    const Region table = rect(20, 20, 80, 60);
    const Region column = rect(40, 30, 60, 50);
    const LayerStack stack = makeStack(kBlock, {{-5, table}, {-10, column}, {-20, column}, {-30, kBlock}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    ASSERT_EQ(set.unplanned.size(), 1U);
    EXPECT_EQ(set.unplanned[0].reason, Reason::Undercut);
    EXPECT_NEAR(set.unplanned[0].volume_mm3, (60 * 40 - 20 * 20) * 15, 1e-3);
    EXPECT_DOUBLE_EQ(set.unplanned[0].top_z_mm, -5);
    EXPECT_DOUBLE_EQ(set.unplanned[0].bottom_z_mm, -20);
    expectBooksClose(stack, set);
}

TEST(RecogniseFeatures, AccountsForVolumeBehindSlopedWalls) {
    LayerStack stack = makeStack(kBlock, {{-10, without(kBlock, rect(15, 15, 85, 65))}, {-30, kBlock}});
    stack.layers[0].vertical_walls = false;
    stack.layers[0].sloped_volume_mm3 = 125;
    stack.part_volume_mm3 -= 125;
    const FeatureSet set = recogniseFeatures(stack, kTol);
    ASSERT_EQ(set.unplanned.size(), 1U);
    EXPECT_EQ(set.unplanned[0].reason, Reason::LeaningWall);
    expectBooksClose(stack, set);
}

TEST(RecogniseFeatures, DropsSliversButKeepsTheirVolume) {
    const LayerStack stack = makeStack(kBlock, {{-10, rect(0.001, 0, 100, 80)}, {-30, kBlock}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    EXPECT_TRUE(set.features.empty());
    ASSERT_EQ(set.unplanned.size(), 1U);
    EXPECT_EQ(set.unplanned[0].reason, Reason::Sliver);
    expectBooksClose(stack, set);
}

TEST(RecogniseFeatures, KeepsAnOpenNeighboursStockInTheWay) {
    // Two steps either side of a rib: a cutter clearing one over its open end must not reach into the other.
    const LayerStack stack = makeStack(kBlock, {{-10, rect(45, 0, 55, 80)}, {-30, kBlock}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    ASSERT_EQ(set.features.size(), 2U);
    EXPECT_NEAR(area(set.features[0].obstruction), 55 * 80, 1e-3);
    EXPECT_NEAR(area(set.features[1].obstruction), 55 * 80, 1e-3);
    EXPECT_EQ(set.features[0].feature_class, FeatureClass::Step);
    EXPECT_NEAR(set.features[0].closed_length_mm, 80, 1e-6);
}

TEST(RecogniseFeatures, LeavesWalledInNeighboursOutOfTheObstruction) {
    const Region part = without(without(kBlock, makeCircle({20, 40}, 5)), makeCircle({80, 40}, 4));
    const LayerStack stack = makeStack(kBlock, {{-10, part}, {-30, kBlock}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    ASSERT_EQ(set.features.size(), 2U);
    for (const Feature& feature : set.features)
        EXPECT_NEAR(area(feature.obstruction), area(part), 1e-3);
}

TEST(RecogniseFeatures, ListsWhatStandsOverTheFloorFromBelowToAbove) {
    // A boss rises over the pocket's rim; a cover of stock above everything goes first.
    const Region rim = without(kBlock, rect(15, 15, 85, 65));
    const Region boss = makeCircle({50, 40}, 8);
    const LayerStack stack = makeStack(
        kBlock,
        {{-5, {}}, {-15, boss}, {-20, unite(rim, boss, kTol)}, {-25, unite(rim, boss, kTol)}, {-30, kBlock}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    ASSERT_EQ(set.features.size(), 3U);
    const Feature& pocket = set.features[2];
    EXPECT_EQ(pocket.parents, std::vector<std::string>{"S1.F2"});
    ASSERT_EQ(pocket.obstacles.size(), 2U);
    EXPECT_DOUBLE_EQ(pocket.obstacles[0].bottom_z_mm, -25);
    EXPECT_DOUBLE_EQ(pocket.obstacles[0].top_z_mm, -15);
    EXPECT_NEAR(area(pocket.obstacles[0].section), 100 * 80 - 70 * 50 + kPi * 64, 1e-3);
    EXPECT_DOUBLE_EQ(pocket.obstacles[1].top_z_mm, -5);
    EXPECT_NEAR(area(pocket.obstacles[1].section), kPi * 64, 1e-3);
    expectBooksClose(stack, set);
}

TEST(RecogniseFeatures, LeavesStepsOfEarlierSetupsOnWallsThatLean) {
    // 2 mm of stock along the upper edge of a block that earlier setups cut, 0.04 % of all there was to
    // remove.
    LayerStack stack = makeStack(kBlock, {{-1, rect(0, 0, 100, 78)}, {-30, kBlock}});
    stack.traces.clear();  // nothing there is level
    stack.stock_cut_before = true;
    stack.removable_mm3 = 5e5;
    const FeatureSet left = recogniseFeatures(stack, kTol);
    EXPECT_TRUE(left.features.empty());
    ASSERT_EQ(left.unplanned.size(), 1U);
    EXPECT_EQ(left.unplanned.front().reason, Reason::LeftByEarlierSetups);
    expectBooksClose(stack, left);

    stack.removable_mm3 = 7e4;  // a lump worth its pass
    EXPECT_EQ(recogniseFeatures(stack, kTol).features.size(), 1U);
}

TEST(RecogniseFeatures, FinishesUprightWallsAfterEarlierSetups) {
    LayerStack stack = makeStack(kBlock, {{-1, rect(0, 0, 100, 78)}, {-30, kBlock}});
    stack.stock_cut_before = true;
    stack.removable_mm3 = 5e5;
    FaceTrace wall;
    wall.face = 0;
    wall.stand = FaceStand::Wall;
    wall.top_z_mm = 0;
    wall.bottom_z_mm = -1;
    wall.footprint = {{100, 78}, {{{0, 78}, {}}}};
    stack.traces = {wall};
    EXPECT_EQ(recogniseFeatures(stack, kTol).features.size(), 1U);
}

/// A block over a solid base, whose stock is what earlier setups left: one region a slab.
LayerStack stackLeftBefore(const std::vector<Region>& stocks, const std::vector<test::Slab>& slabs) {
    LayerStack stack = makeStack(kBlock, slabs);
    for (std::size_t i = 0; i < stocks.size(); ++i) {
        const Layer& layer = stack.layers[i];
        stack.stock_volume_mm3 -= (area(layer.stock) - area(stocks[i])) * layer.height_mm();
        stack.layers[i].stock = stocks[i];
    }
    return stack;
}

TEST(RecogniseFeatures, StairsOfEarlierSetupsAreOneFeature) {
    // Stairs up to a wall, and a second flight that meets them at the bottom.
    const Region wall = rect(80, 0, 100, 80);
    const LayerStack stack =
        stackLeftBefore({rect(60, 0, 100, 80), unite(rect(40, 0, 100, 80), rect(0, 0, 10, 80), kTol), kBlock},
                        {{-5, wall}, {-10, wall}, {-15, wall}, {-30, kBlock}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    ASSERT_EQ(set.features.size(), 1U);
    const Feature& feature = set.features.front();
    EXPECT_EQ(feature.feature_class, FeatureClass::Step);
    EXPECT_DOUBLE_EQ(feature.top_z_mm, 0);
    EXPECT_DOUBLE_EQ(feature.floor_z_mm, -15);
    EXPECT_NEAR(feature.area_mm2, 80 * 80, 1e-6);
    EXPECT_NEAR(feature.volume_mm3, 80 * 5 * (20 + 40 + 10 + 80), 1e-6);
    expectBooksClose(stack, set);
}

TEST(RecogniseFeatures, StairsOverFloorsAreFeaturesOfTheirOwn) {
    // The part has a floor under the upper stair: cutting both at once would cut it.
    const LayerStack stack =
        stackLeftBefore({rect(60, 0, 100, 80), kBlock},
                        {{-5, rect(80, 0, 100, 80)}, {-10, rect(60, 0, 100, 80)}, {-30, kBlock}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    ASSERT_EQ(set.features.size(), 2U);
    EXPECT_NEAR(set.features[0].area_mm2, 20 * 80, 1e-6);
    EXPECT_NEAR(set.features[1].area_mm2, 60 * 80, 1e-6);
    expectBooksClose(stack, set);
}

TEST(RecogniseFeatures, CrumbsLeadNoFeatureDownThroughWhatWasCut) {
    // A slot that the setup before has cut from below but for its corners.
    const Region slot = rect(0, 36, 10, 44);
    const Region crumbs = unite(rect(0, 36, 0.5, 36.5), rect(0, 43.5, 0.5, 44), kTol);
    const Region part = subtract(kBlock, slot, kTol);
    const LayerStack stack = stackLeftBefore({kBlock, unite(part, crumbs, kTol)}, {{-33, part}, {-80, part}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    ASSERT_FALSE(set.features.empty());
    EXPECT_DOUBLE_EQ(set.features.front().floor_z_mm, -33);
    EXPECT_NEAR(set.features.front().volume_mm3, 80 * 33, 1e-6);
    expectBooksClose(stack, set);
}

TEST(RecogniseFeatures, AFeatureHoldsNoMoreAirThanMaterial) {
    // A thin rib high over a wide floor: feeding through the air beside it would take longer than a feature.
    const LayerStack stack =
        stackLeftBefore({rect(0, 0, 5, 80), kBlock}, {{-40, Region{}}, {-45, Region{}}, {-60, kBlock}});
    const FeatureSet set = recogniseFeatures(stack, kTol);
    EXPECT_EQ(set.features.size(), 2U);
    expectBooksClose(stack, set);
}

}  // namespace
}  // namespace stepmill
