#include <gtest/gtest.h>

#include "support/sample_feature.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

using test::kTol;

/// A mill of 10 mm in a holder of 40 mm that may be set out from 6 to 30 mm.
ToolAssembly rangedMill() {
    ToolAssembly tool = inHolder(makeMill(10), 30, 40, 30);
    tool.flute_length_mm = 5;
    tool.stick_out_range = StickOutRange{6, 30};
    return tool;
}

Feature pocketOf(double depth_mm) {
    return makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(70, 50), 6), depth_mm);
}

double leastFor(const Feature& feature, const ToolAssembly& tool) {
    const ToolSequence sequence =
        sequenceTools(feature, makeLibrary({tool}), makeMachine(), inAluminium(), kTol);
    EXPECT_EQ(sequence.steps.size(), 1U);
    return sequence.steps.empty() ? 0 : sequence.steps[0].least_stick_out_mm;
}

TEST(StickOut, IsTheShortestWholeStepThatClearsTheWalls) {
    EXPECT_DOUBLE_EQ(leastFor(pocketOf(12), rangedMill()), 12);
    EXPECT_DOUBLE_EQ(leastFor(pocketOf(12.3), rangedMill()), 13);
    EXPECT_DOUBLE_EQ(leastFor(pocketOf(4), rangedMill()), 6);
}

TEST(StickOut, IsTheToolsOwnWithoutARange) {
    ToolAssembly tool = rangedMill();
    tool.stick_out_range.reset();
    EXPECT_DOUBLE_EQ(leastFor(pocketOf(12), tool), 30);
}

TEST(StickOut, CountsTheRangeInStepsFromItsShorterEnd) {
    ToolAssembly tool = rangedMill();
    tool.stick_out_range = StickOutRange{6.5, 30};
    EXPECT_DOUBLE_EQ(leastFor(pocketOf(12), tool), 12.5);
}

TEST(StickOut, APocketDeeperThanTheRangeIsCutAsDeepAsTheLongestReaches) {
    const ToolSequence sequence =
        sequenceTools(pocketOf(40), makeLibrary({rangedMill()}), makeMachine(), inAluminium(), kTol);
    ASSERT_FALSE(sequence.steps.empty());
    EXPECT_NEAR(sequence.floor_z_mm, -30, 0.01);
    EXPECT_DOUBLE_EQ(sequence.steps[0].least_stick_out_mm, 30);
    ASSERT_FALSE(sequence.residual.empty());
    EXPECT_NE(sequence.residual.back().advice.find("40"), std::string::npos)
        << sequence.residual.back().advice;
}

TEST(StickOut, ADrillIsSetOutAsFarAsItsHoleIsDeep) {
    Feature hole = makePocket(makeCircle(Vec2(20, 20), 4), 25, FeatureClass::HoleThrough);
    hole.through = true;
    ToolAssembly drill = makeDrill(8);
    drill.flute_length_mm = 40;
    drill.stick_out_mm = 80;
    drill.stick_out_range = StickOutRange{40, 80};
    drill.holder = {{30, 80, 120}};
    EXPECT_DOUBLE_EQ(leastFor(hole, drill), 40);
}

TEST(StickOut, SettingAToolOutMovesItsHolderAndNotItsFlutes) {
    ToolAssembly tool = rangedMill();
    tool.shank = {9, 6, 30};
    const ToolAssembly set = setTo(tool, 14);
    EXPECT_DOUBLE_EQ(set.stick_out_mm, 14);
    EXPECT_DOUBLE_EQ(set.shank.bottom_mm, 6);
    EXPECT_DOUBLE_EQ(set.shank.top_mm, 14);
    EXPECT_DOUBLE_EQ(set.holder[0].bottom_mm, 14);
    EXPECT_DOUBLE_EQ(set.holder[0].top_mm, 44);
    EXPECT_DOUBLE_EQ(set.flute_length_mm, 5);
}

}  // namespace
}  // namespace stepmill::test
