// Ground that nested features share.

#include <gtest/gtest.h>

#include "plan/features/nests.h"
#include "stepmill/feature/describe_boundary.h"
#include "stepmill/plan/common_ground.h"
#include "stepmill/planar/boolean.h"
#include "support/grounds.h"
#include "support/shape_makers.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using namespace test;

using test::kTol;

Feature pocket(const std::string& id, const Region& target, double top_mm, double floor_mm,
               std::vector<std::string> parents) {
    Feature feature = closedPocket(target, top_mm - floor_mm);
    feature.id = id;
    feature.parents = std::move(parents);
    feature.top_z_mm = top_mm;
    feature.floor_z_mm = floor_mm;
    feature.obstacles = {{floor_mm, 0, feature.obstruction}};
    describeBoundary(feature, kTol);
    return feature;
}

/// Three pockets one in another, 4, 2 and 6 deep, and a hole in the second one's floor.
std::vector<Feature> threeLevels() {
    return {pocket("S1.F1", makeRectangle({0, 0}, {60, 40}), 0, -4, {}),
            pocket("S1.F2", makeRectangle({0, 0}, {50, 40}), -4, -6, {"S1.F1"}),
            pocket("S1.F3", makeRectangle({0, 0}, {40, 40}), -6, -12, {"S1.F2"}),
            pocket("S1.F4", makeCircle({45, 20}, 3), -6, -9, {"S1.F2"})};
}

/// Down to the floor of the last level.
CommonGround groundOf(const std::vector<std::string>& levels, const Region& region) {
    CommonGround ground{"S1.G1.1", levels, region};
    for (const Feature& level : threeLevels())
        if (level.id == levels.back()) ground.floor_z_mm = level.floor_z_mm;
    return ground;
}

double volumeMm3(const std::vector<Feature>& features) {
    double sum_mm3 = 0;
    for (const Feature& feature : features)
        sum_mm3 += feature.volume_mm3;
    return sum_mm3;
}

TEST(Nests, GoOnInTheWidestChildThatIsNoHole) {
    const std::vector<Nest> nests = nestsOf(threeLevels());
    ASSERT_EQ(nests.size(), 2U);
    EXPECT_EQ(nests[0], (Nest{0, 1, 2}));
    EXPECT_EQ(nests[1], (Nest{3}));
    const auto generations = generationsOf(nests, threeLevels());
    ASSERT_EQ(generations.size(), 2U);
    EXPECT_EQ(generations[1], (std::vector<std::size_t>{1}));
}

TEST(CommonGround, IsCutBeforeWhatItsLevelsKeep) {
    const Region region = makeRoundedRectangle({0, 0}, {40, 40}, 5);
    const std::vector<Feature> before = threeLevels();
    const CommonGround ground = groundOf({"S1.F1", "S1.F2", "S1.F3"}, region);
    ASSERT_TRUE(isCommonGround(before, ground, kTol));
    const std::vector<Feature> after = withCommonGround(before, ground, kTol);
    ASSERT_EQ(after.size(), 5U);
    EXPECT_EQ(after[0].id, "S1.G1.1");
    EXPECT_EQ(after[0].ground_of, ground.levels);
    EXPECT_TRUE(after[0].parents.empty());
    EXPECT_DOUBLE_EQ(after[0].top_z_mm, 0);
    EXPECT_DOUBLE_EQ(after[0].floor_z_mm, -12);
    EXPECT_EQ(after[1].parents, std::vector<std::string>{"S1.G1.1"});
    EXPECT_EQ(after[2].parents, std::vector<std::string>{"S1.F1"});
    EXPECT_NEAR(after[2].area_mm2, 50 * 40 - area(region), 1e-6);
    EXPECT_NEAR(volumeMm3(after), volumeMm3(before), 1e-6);
}

TEST(CommonGround, KeepsCutterAndHolderOffWhatItsLevelsKeep) {
    const Region region = makeRoundedRectangle({0, 0}, {40, 40}, 5);
    const std::vector<Feature> after =
        withCommonGround(threeLevels(), groundOf({"S1.F1", "S1.F2", "S1.F3"}, region), kTol);
    EXPECT_NEAR(area(intersect(after[0].obstruction, makeRectangle({40, 0}, {60, 40}), kTol)), 800, 1e-6);
    EXPECT_LE(after[0].open_length_mm, kTol.sliver_mm);
    EXPECT_DOUBLE_EQ(after[0].obstacles.back().top_z_mm, 0);
    // The levels come in over it.
    EXPECT_GT(after[1].open_length_mm, 60);
}

TEST(CommonGround, TakesALevelWhole) {
    const std::vector<Feature> before = threeLevels();
    const CommonGround ground = groundOf({"S1.F1", "S1.F2"}, before[1].target);
    const std::vector<Feature> after = withCommonGround(before, ground, kTol);
    ASSERT_EQ(after.size(), 4U);
    EXPECT_EQ(after[1].id, "S1.F1");
    // What waited for the level that is gone waits for the one above, which waits for the ground.
    EXPECT_EQ(after[2].id, "S1.F3");
    EXPECT_EQ(after[2].parents, std::vector<std::string>{"S1.F1"});
    EXPECT_EQ(after[3].parents, std::vector<std::string>{"S1.F1"});
    EXPECT_NEAR(volumeMm3(after), volumeMm3(before), 1e-6);
}

TEST(CommonGround, IsNoneWhereNothingIsLeftOfIt) {
    const Region sliver = makeRectangle({10, 10}, {10 + kTol.sliver_mm / 2, 30});
    for (const Region& region : {Region{}, sliver})
        EXPECT_FALSE(isCommonGround(threeLevels(), groundOf({"S1.F1", "S1.F2"}, region), kTol));
}

TEST(CommonGround, IsNoneWhereALevelDoesNotHaveIt) {
    const std::vector<Feature> features = threeLevels();
    const Region wide = makeRectangle({0, 0}, {50, 40});
    EXPECT_TRUE(isCommonGround(features, groundOf({"S1.F1", "S1.F2"}, wide), kTol));
    EXPECT_FALSE(isCommonGround(features, groundOf({"S1.F1", "S1.F2", "S1.F3"}, wide), kTol));
    EXPECT_FALSE(isCommonGround(features, groundOf({"S1.F1", "S1.F3"}, features[2].target), kTol));
    EXPECT_FALSE(isCommonGround(features, groundOf({"S1.F3"}, features[2].target), kTol));
}

TEST(CommonGround, OfOneLevelIsAPartOfItOrADepth) {
    const std::vector<Feature> features = threeLevels();
    const Region bulk = makeRoundedRectangle({0, 0}, {40, 40}, 5);
    EXPECT_TRUE(isCommonGround(features, groundOf({"S1.F3"}, bulk), kTol));
    CommonGround upper = groundOf({"S1.F3"}, features[2].target);
    upper.floor_z_mm = -9;
    EXPECT_TRUE(isCommonGround(features, upper, kTol));
    upper.floor_z_mm = features[2].top_z_mm;
    EXPECT_FALSE(isCommonGround(features, upper, kTol)) << "nothing is above its floor";
    // What lies below would be no prism.
    CommonGround part = groundOf({"S1.F3"}, bulk);
    part.floor_z_mm = -9;
    EXPECT_FALSE(isCommonGround(features, part, kTol));
}

TEST(CommonGround, DownToADepthLeavesTheLevelBelow) {
    const std::vector<Feature> before = threeLevels();
    CommonGround upper = groundOf({"S1.F3"}, before[2].target);
    upper.floor_z_mm = -9;
    const std::vector<Feature> after = withCommonGround(before, upper, kTol);
    ASSERT_EQ(after.size(), 5U);
    EXPECT_EQ(after[2].id, "S1.G1.1");
    EXPECT_EQ(after[2].parents, before[2].parents);
    EXPECT_DOUBLE_EQ(after[2].top_z_mm, -6);
    EXPECT_DOUBLE_EQ(after[2].floor_z_mm, -9);
    EXPECT_EQ(after[3].id, "S1.F3");
    EXPECT_EQ(after[3].parents, std::vector<std::string>{"S1.G1.1"});
    EXPECT_DOUBLE_EQ(after[3].top_z_mm, -9);
    EXPECT_DOUBLE_EQ(after[3].floor_z_mm, -12);
    EXPECT_NEAR(volumeMm3(after), volumeMm3(before), 1e-6);
}

}  // namespace
}  // namespace stepmill
