#include "stepmill/sequence/advice/purchase.h"

#include <gtest/gtest.h>

#include "sequence/advice/trial_tools.h"
#include "support/sample_feature.h"
#include "support/tolerances.h"

namespace stepmill::test {
namespace {

using test::kTol;

/// In a holder, with the shank between flutes and holder.
ToolAssembly withShank(ToolAssembly tool, double stick_out_mm, double holder_mm) {
    tool.shank = {tool.diameter_mm, tool.flute_length_mm, stick_out_mm};
    return inHolder(tool, stick_out_mm, holder_mm);
}

TEST(TrialTools, BetweenTwoNeighboursDataAreInterpolated) {
    ToolAssembly narrow = makeMill(8, 1000, 4);
    ToolAssembly wide = makeMill(12, 1400, 6);
    narrow.price = 20;
    wide.price = 40;
    wide.stick_out_mm = 70;
    const auto tool = interpolatedTool(makeLibrary({wide, narrow}), ToolType::Flat, 9, 10, "aluminium");
    ASSERT_TRUE(tool);
    const CuttingData& data = *tool->cuttingFor("aluminium");
    EXPECT_DOUBLE_EQ(tool->diameter_mm, 9);
    EXPECT_DOUBLE_EQ(data.feed_mm_per_min, 1100);
    EXPECT_DOUBLE_EQ(data.step_down_mm, 4.5);
    EXPECT_DOUBLE_EQ(data.step_over_mm, 4.5);
    EXPECT_DOUBLE_EQ(tool->price, 25);
    EXPECT_DOUBLE_EQ(tool->stick_out_mm, 62.5);
    EXPECT_EQ(tool->number, 3);
}

TEST(TrialTools, BeyondTheLastNeighbourDataGoWithTheDiameterButNotFar) {
    const ToolLibrary library = makeLibrary({makeMill(10, 1000, 4)});
    const auto tool = interpolatedTool(library, ToolType::Flat, 8, 10, "aluminium");
    ASSERT_TRUE(tool);
    const CuttingData& data = *tool->cuttingFor("aluminium");
    EXPECT_DOUBLE_EQ(data.feed_mm_per_min, 1000);
    EXPECT_DOUBLE_EQ(data.step_down_mm, 3.2);
    EXPECT_DOUBLE_EQ(data.speed_rpm, 12500);
    EXPECT_DOUBLE_EQ(tool->flute_length_mm, 32);
    EXPECT_FALSE(interpolatedTool(library, ToolType::Flat, 5, 10, "aluminium"));
    EXPECT_FALSE(interpolatedTool(library, ToolType::Flat, 16, 10, "aluminium"));
}

TEST(TrialTools, OnlyNeighboursThatGetDownCount) {
    ToolAssembly shorter = makeMill(12);
    shorter.stick_out_mm = 15;
    const ToolLibrary library = makeLibrary({makeMill(8), shorter, makeMill(14)});
    EXPECT_DOUBLE_EQ(interpolatedTool(library, ToolType::Flat, 11, 20, "aluminium")->stick_out_mm, 60);
    EXPECT_FALSE(interpolatedTool(library, ToolType::Flat, 11, 100, "aluminium"));
    EXPECT_FALSE(interpolatedTool(library, ToolType::Flat, 11, 20, "cheese"));
}

TEST(TrialTools, ALongerStickOutMovesShankAndHolderAlong) {
    const ToolAssembly tool = withShank(makeMill(10), 50, 30);
    const auto longer = withStickOut(tool, 56.2);
    ASSERT_TRUE(longer);
    EXPECT_DOUBLE_EQ(longer->stick_out_mm, 57);
    EXPECT_DOUBLE_EQ(longer->shank.top_mm, 57);
    EXPECT_DOUBLE_EQ(longer->shank.bottom_mm, tool.shank.bottom_mm);
    EXPECT_DOUBLE_EQ(longer->holder[0].bottom_mm, 57);
    EXPECT_DOUBLE_EQ(longer->holder[0].top_mm, 97);
    EXPECT_NEAR(longer->cutting[0].feed_mm_per_min, 1200 * 50.0 / 57, 1e-9);
    EXPECT_NEAR(longer->cutting[0].step_down_mm, 4 * 50.0 / 57, 1e-9);
    EXPECT_FALSE(withStickOut(tool, 50));
    EXPECT_FALSE(withStickOut(tool, 101));  // more than ten diameters
}

TEST(TrialTools, MillsAreThoseTheLibraryLacksWithCornersAndNecksFirst) {
    const Feature pocket = makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(60, 40), 5.6), 10);
    const FeatureGround ground(pocket, kTol);
    const auto trials = trialMills(ground, makeLibrary({makeMill(20), makeMill(6)}), "aluminium");
    bool corner = false;
    for (const TrialTool& trial : trials) {
        EXPECT_GT(std::abs(trial.tool.diameter_mm - 20), 0.04);
        EXPECT_GT(std::abs(trial.tool.diameter_mm - 6), 0.04);
        corner = corner || std::abs(trial.tool.diameter_mm - 11.2) < 1e-9;
    }
    EXPECT_TRUE(corner);
}

TEST(WhatToBuy, FindsTheCutterOfTheCornersBetweenTooLargeAndTooSmall) {
    const Feature pocket = makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(60, 40), 6), 12);
    const ToolLibrary library = makeLibrary({makeMill(20), makeMill(4, 600, 1)});
    const PurchaseAdvice advice = whatToBuy(pocket, library, makeMachine(), inAluminium(), kTol);
    ASSERT_TRUE(advice.best);
    EXPECT_GT(advice.best->saved_s, 0);
    EXPECT_LE(advice.best->tool.diameter_mm, 12);
    EXPECT_GT(advice.best->tool.diameter_mm, 4);
    EXPECT_LE(advice.trials, kPurchaseTrials);
    ToolLibrary bought = library;
    bought.tools.push_back(advice.best->tool);
    const ToolSequence with = sequenceTools(pocket, bought, makeMachine(), inAluminium(), kTol);
    EXPECT_NEAR(advice.time_s - with.time_s, advice.best->saved_s, 1e-9);
}

TEST(WhatToBuy, AsksForAStickOutThatClearsTheHolder) {
    const Feature pocket = makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(60, 40), 6), 30);
    const ToolLibrary library = makeLibrary({withShank(makeMill(12), 20, 50)});
    const PurchaseAdvice advice = whatToBuy(pocket, library, makeMachine(), inAluminium(), kTol);
    EXPECT_GT(advice.stays_mm3, 0);
    ASSERT_TRUE(advice.best);
    EXPECT_DOUBLE_EQ(advice.best->tool.diameter_mm, 12);
    EXPECT_GE(advice.best->tool.stick_out_mm, 30);
    EXPECT_NEAR(advice.best->more_mm3, advice.stays_mm3, 1e-3 * pocket.volume_mm3);
}

TEST(WhatToBuy, SaysNothingWhereNothingHelps) {
    // One pass of the right cutter: a change of tools could only cost.
    const Feature slot = makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(40, 10.02), 5.01), 4);
    const ToolLibrary library = makeLibrary({makeMill(10)});
    const PurchaseAdvice advice = whatToBuy(slot, library, makeMachine(), inAluminium(), kTol);
    EXPECT_GT(advice.time_s, 0);
    EXPECT_FALSE(advice.best);
}

TEST(PurchasesFrom, TellsWhichOfferedToolsHelpAndByHowMuch) {
    const Feature pocket = makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(60, 40), 6), 12);
    const ToolLibrary library = makeLibrary({makeMill(20), makeMill(4, 600, 1)});
    // The first fits the corners, the second does not reach them, the third does nothing that the 4 does not.
    std::vector<ToolAssembly> offers{makeMill(12), makeMill(30), makeMill(3, 200, 0.5)};
    for (std::size_t i = 0; i < offers.size(); ++i) {
        offers[i].id = "offer" + std::to_string(i);
        offers[i].number = static_cast<int>(90 + i);
    }
    const std::vector<Purchase> found =
        purchasesFrom(offers, pocket, library, makeMachine(), inAluminium(), kTol);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found.front().tool.id, "offer0");
    EXPECT_GT(found.front().saved_s, 0);
    ToolLibrary bought = library;
    bought.tools.push_back(offers.front());
    const double without_s = sequenceTools(pocket, library, makeMachine(), inAluminium(), kTol).time_s;
    const double with_s = sequenceTools(pocket, bought, makeMachine(), inAluminium(), kTol).time_s;
    EXPECT_NEAR(found.front().saved_s, without_s - with_s, 1e-9);
}

TEST(PurchasesFrom, LeavesOutWhatTheLibraryHas) {
    const Feature pocket = makePocket(makeRoundedRectangle(Vec2(0, 0), Vec2(60, 40), 6), 12);
    const ToolLibrary library = makeLibrary({makeMill(20), makeMill(12)});
    EXPECT_TRUE(purchasesFrom(library.tools, pocket, library, makeMachine(), inAluminium(), kTol).empty());
}

}  // namespace
}  // namespace stepmill::test
