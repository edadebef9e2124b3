// Which of two sets of setups is the better one.

#include "plan/assignment/setup_choice.h"

#include <gtest/gtest.h>

namespace stepmill::test {
namespace {

constexpr double kRemovedMm3 = 1e5;
constexpr Alike kAlike{0.002, 0};

Machine shopMachine() {
    Machine machine;
    machine.setup_time_min = 10;
    machine.indexed_setup_time_min = 30;
    machine.load_time_s = 0;
    machine.hourly_rate = 60;
    return machine;
}

std::vector<stepmill::Setup> someSetups(int count) {
    std::vector<stepmill::Setup> setups(static_cast<std::size_t>(count));
    return setups;
}

/// A plan that cuts in so many setups, all in a vise.
Plan planOf(int setups, double minutes, double stays_mm3) {
    Plan plan;
    plan.totals.motion_s = 60 * minutes;
    plan.totals.cost = minutes;
    plan.balance.stock_minus_part_mm3 = kRemovedMm3;
    plan.balance.unreachable_mm3 = stays_mm3;
    plan.setups.resize(static_cast<std::size_t>(setups));
    for (PlannedSetup& setup : plan.setups) {
        setup.clamping.kind = HoldKind::Vise;
        setup.operations.resize(1);
    }
    return plan;
}

class SetupChoiceOf : public testing::Test {
  protected:
    PlanRequest request_;
    Machine machine_ = shopMachine();
    SetupWeigher weigher_{request_, machine_};
};

TEST_F(SetupChoiceOf, OneSetupNeedsNoOtherPlanWhereSettingUpTakesLonger) {
    EXPECT_TRUE(weigher_.cannotBeat(planOf(1, 15, 0), someSetups(3), kAlike));
    EXPECT_FALSE(weigher_.cannotBeat(planOf(1, 25, 0), someSetups(3), kAlike));
    EXPECT_FALSE(weigher_.cannotBeat(planOf(1, 15, 0.01 * kRemovedMm3), someSetups(3), kAlike));
}

TEST_F(SetupChoiceOf, AnIndexedSetupTakesItsOwnTime) {
    std::vector<stepmill::Setup> setups = someSetups(2);
    EXPECT_DOUBLE_EQ(weigher_.settingUpS(setups), 20 * 60);
    setups.back().indexed = true;
    EXPECT_DOUBLE_EQ(weigher_.settingUpS(setups), 40 * 60);
    request_.quantity = 8;
    EXPECT_DOUBLE_EQ(weigher_.settingUpS(setups), 5 * 60);
    machine_.load_time_s = 30;
    EXPECT_DOUBLE_EQ(weigher_.settingUpS(setups), 5 * 60 + 2 * 30) << "each piece is loaded twice";
}

TEST_F(SetupChoiceOf, RidgesAsHighAsAllowedCountAsNothing) {
    const Alike with_ridges{kAlike.share, 0.02 * kRemovedMm3};
    EXPECT_EQ(weigher_.against(planOf(3, 90, 0), planOf(1, 10, 0.01 * kRemovedMm3), with_ridges),
              std::nullopt);
    EXPECT_EQ(weigher_.against(planOf(3, 90, 0), planOf(1, 10, 0.03 * kRemovedMm3), with_ridges),
              SetupVerdict::LeavesMore);
}

TEST_F(SetupChoiceOf, MoreSetupsAreTakenWhereTheyLeaveMuchLess) {
    EXPECT_EQ(weigher_.against(planOf(1, 10, 0.01 * kRemovedMm3), planOf(3, 90, 0), kAlike), std::nullopt);
    EXPECT_EQ(weigher_.whyNot(planOf(1, 10, 0.01 * kRemovedMm3), planOf(3, 90, 0), kAlike),
              SetupVerdict::LeavesMore);
    EXPECT_EQ(weigher_.against(planOf(1, 10, 0), planOf(3, 90, 0.01 * kRemovedMm3), kAlike),
              SetupVerdict::LeavesMore);
}

TEST_F(SetupChoiceOf, OfPlansThatLeaveAsMuchTheShorterIsTakenSettingUpCounted) {
    // Two setups more are twenty minutes.
    EXPECT_EQ(weigher_.against(planOf(1, 50, 100), planOf(3, 35, 0), kAlike), SetupVerdict::TakesLonger);
    EXPECT_EQ(weigher_.against(planOf(1, 50, 100), planOf(3, 25, 0), kAlike), std::nullopt);
    EXPECT_EQ(weigher_.whyNot(planOf(1, 50, 100), planOf(3, 25, 0), kAlike), SetupVerdict::TakesLonger);
}

TEST_F(SetupChoiceOf, HowMuchIsAlikeIsSaid) {
    const Plan leaves_more = planOf(1, 10, 0.001 * kRemovedMm3);
    EXPECT_EQ(weigher_.against(planOf(2, 30, 0), leaves_more, Alike{0.002, 0}), std::nullopt);
    EXPECT_EQ(weigher_.against(planOf(2, 30, 0), leaves_more, Alike{0.0002, 0}), SetupVerdict::LeavesMore);
}

TEST_F(SetupChoiceOf, InALargeLotSettingUpHardlyCounts) {
    request_.quantity = 100;
    EXPECT_EQ(weigher_.against(planOf(1, 50, 100), planOf(3, 35, 0), kAlike), std::nullopt);
    EXPECT_FALSE(weigher_.cannotBeat(planOf(1, 15, 0), someSetups(3), kAlike));
}

TEST_F(SetupChoiceOf, ASetupThatNothingHoldsDecidesBeforeTime) {
    Plan loose = planOf(1, 10, 0);
    loose.setups.front().clamping.kind = HoldKind::None;
    EXPECT_FALSE(weigher_.cannotBeat(loose, someSetups(3), kAlike));
    EXPECT_EQ(weigher_.against(loose, planOf(2, 60, 0), kAlike), std::nullopt);
    EXPECT_EQ(weigher_.whyNot(loose, planOf(2, 60, 0), kAlike), SetupVerdict::HeldWorse);
    // A setup in which nothing is cut needs no hold, and no setting up.
    Plan idle = planOf(2, 60, 0);
    idle.setups.back().clamping.kind = HoldKind::None;
    idle.setups.back().operations.clear();
    EXPECT_EQ(weigher_.choiceOf(idle, someSetups(2), SetupVerdict::Taken).planned->setup_s, 10 * 60);
    EXPECT_EQ(weigher_.against(planOf(1, 80, 0), idle, kAlike), std::nullopt);
}

TEST_F(SetupChoiceOf, ByCostSettingUpIsPaidAtTheMachinesRate) {
    request_.sequence.objective = Objective::Cost;
    // Twenty minutes are 20 at 60 an hour.
    EXPECT_EQ(weigher_.against(planOf(1, 50, 0), planOf(3, 35, 0), kAlike), SetupVerdict::TakesLonger);
    EXPECT_EQ(weigher_.against(planOf(1, 50, 0), planOf(3, 25, 0), kAlike), std::nullopt);
}

}  // namespace
}  // namespace stepmill::test
