#include "setup/cover.h"

#include <gtest/gtest.h>

using namespace stepmill::setup;

namespace {

SampleGroup group(std::vector<Reach> reach, double share, double faces = 0) {
    SampleGroup made;
    made.depth_mm.assign(reach.size(), 1.0);
    made.reach = std::move(reach);
    made.volume_share = share;
    made.faces = faces;
    made.ruled_share = share;
    return made;
}

const Reach N = Reach::None;
const Reach P = Reach::Poor;
const Reach S = Reach::Steps;
const Reach F = Reach::Finished;

}  // namespace

TEST(BestAxes, TakesNoAxisWhereNothingIsToBeRemoved) {
    EXPECT_TRUE(bestAxes({}, {0, 0}).empty());
}

TEST(BestAxes, FindsThePairThatAGreedyChoiceMisses) {
    // The first axis reaches most alone, but the other two together reach all.
    const std::vector<SampleGroup> groups = {group({F, F, N}, 0.35), group({F, N, F}, 0.35),
                                             group({N, F, N}, 0.15), group({N, N, F}, 0.15)};
    EXPECT_EQ(bestAxes(groups, {0, 0, 0}), (std::vector<int>{1, 2}));
}

TEST(BestAxes, AxesThatCostMoreDoNotHideABetterPair) {
    // The first two and the next two see all; dear axes that see much as well must not end the search early.
    const std::vector<SampleGroup> groups = {group({F, F, N, F, F, F, N, F}, 0.3),
                                             group({N, F, F, N, F, N, F, F}, 0.3),
                                             group({F, N, F, F, N, F, F, N}, 0.4)};
    EXPECT_EQ(bestAxes(groups, {0, 0, 0.01, 0.01, -1, -1, -1, -1}, true), (std::vector<int>{2, 3}));
}

TEST(BestAxes, KeepsNoSlantedAxisWhoseWorkTheOthersDo) {
    // The slanted ones see most each, so the search begins with one of them, and ends before it has tried
    // without.
    const std::vector<SampleGroup> groups = {group({F, F, N, F, F}, 0.4), group({F, N, F, F, F}, 0.4),
                                             group({N, F, N, N, N}, 0.1), group({N, N, F, N, N}, 0.1)};
    EXPECT_EQ(bestAxes(groups, {-1, 0, 0, -1, -1}), (std::vector<int>{1, 2}));
}

TEST(BestAxes, PutsAnAxisAlongTheBoxInThePlaceOfASlantedOne) {
    const std::vector<SampleGroup> groups = {group({F, F, N, F, F}, 0.5), group({F, N, F, F, F}, 0.3),
                                             group({N, F, F, N, N}, 0.2)};
    EXPECT_EQ(bestAxes(groups, {-1, 0, 0, -1, -1}), (std::vector<int>{1, 2}));
}

TEST(BestAxes, LeavesOutAnAxisThatDoesNotPay) {
    const std::vector<SampleGroup> groups = {group({F, N}, 1 - kSetupPaysShare / 2),
                                             group({N, F}, kSetupPaysShare / 2)};
    EXPECT_EQ(bestAxes(groups, {0, 0}), (std::vector<int>{0}));
}

TEST(BestAxes, PaysForASmallFaceThatNoOtherAxisReaches) {
    const std::vector<SampleGroup> groups = {group({F, N}, 1 - 1e-6, 4), group({N, F}, 1e-6, 1)};
    EXPECT_EQ(bestAxes(groups, {0, 0}), (std::vector<int>{0, 1}));
}

TEST(BestAxes, PrefersTheAxisThatFinishesTheFace) {
    const std::vector<SampleGroup> groups = {group({P, F}, 1)};
    EXPECT_EQ(bestAxes(groups, {0, 0}), (std::vector<int>{1}));
}

TEST(BestAxes, TakesAFurtherAxisOnlyForEnoughToFinish) {
    const auto withSlope = [](double share) {
        return bestAxes({group({F, N}, 1 - share), group({P, F}, share)}, {0, 0});
    };
    EXPECT_EQ(withSlope(kFinishPaysShare / 2), (std::vector<int>{0}));
    EXPECT_EQ(withSlope(kFinishPaysShare * 2), (std::vector<int>{0, 1}));
}

TEST(BestAxes, TakesNoAxisForStepsThatAreFinishedFromTheOther) {
    const auto withFaces = [](Reach reach, bool steps_finished) {
        return bestAxes({group({F, N}, 0.5), group({reach, F}, 0.5)}, {0, 0}, steps_finished);
    };
    EXPECT_EQ(withFaces(S, false), (std::vector<int>{0, 1}));
    EXPECT_EQ(withFaces(S, true), (std::vector<int>{0}));
    // Deep in a gap is no better with form cutters.
    EXPECT_EQ(withFaces(P, true), (std::vector<int>{0, 1}));
}

TEST(BestAxes, TakesTheLargerBonusAmongEquals) {
    EXPECT_EQ(bestAxes({group({F, F}, 1)}, {0.001, 0.002}), (std::vector<int>{1}));
    EXPECT_EQ(bestAxes({group({F, F}, 1)}, {0.002, 0.002}), (std::vector<int>{0}));
}
