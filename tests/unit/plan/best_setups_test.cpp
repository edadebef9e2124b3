// Which sets of setups are planned, and which plan is taken.

#include "plan/assignment/best_setups.h"

#include <gtest/gtest.h>

#include "stepmill/core/error.h"

namespace stepmill::test {
namespace {

constexpr double kRemovedMm3 = 1e5;

std::vector<stepmill::Setup> along(const std::vector<Vec3>& axes) {
    std::vector<stepmill::Setup> setups;
    for (const Vec3& axis : axes) {
        stepmill::Setup setup;
        setup.axis = axis;
        setups.push_back(setup);
    }
    return setups;
}

const Vec3 kX = Vec3::UnitX();
const Vec3 kY = Vec3::UnitY();
const Vec3 kZ = Vec3::UnitZ();

/// Makes plans whose minutes and rest are told by the first axis, all in a vise.
class SetupSearchOf : public testing::Test {
  protected:
    struct Outcome {
        double minutes = 10;
        double stays_mm3 = 0;
        double bound_minutes = 0;
        std::size_t operations = 1;  ///< in each setup
        std::optional<ErrorCode> fails = std::nullopt;
    };

    SetupSearchOf() {
        machine_.setup_time_min = 10;
        machine_.indexed_setup_time_min = 30;
        machine_.load_time_s = 0;
    }

    Plan best() {
        return bestPlan(sets_, request_, machine_, [this](const auto& setups, const Deadline&) {
            ++planned_;
            const Outcome outcome = outcomeOf(setups);
            if (outcome.fails) throw Error(*outcome.fails, "a part", "no plan");
            Plan plan;
            plan.totals.motion_s = 60 * outcome.minutes;
            plan.totals.lower_bound_s = 60 * outcome.bound_minutes;
            plan.balance.stock_minus_part_mm3 = kRemovedMm3;
            plan.balance.unreachable_mm3 = outcome.stays_mm3;
            for (const stepmill::Setup& setup : setups) {
                PlannedSetup& cut = plan.setups.emplace_back();
                cut.setup = setup;
                cut.clamping.kind = HoldKind::Vise;
                cut.operations.resize(outcome.operations);
            }
            return plan;
        });
    }

    Outcome outcomeOf(const std::vector<stepmill::Setup>& setups) const {
        if (setups.front().axis == kX) return from_x_;
        return setups.size() == 1 ? few_ : chosen_;
    }

    PlanRequest request_;
    Machine machine_;
    SetupSets sets_{along({kZ, kX}), {}, 0, {}};
    Outcome chosen_;
    Outcome few_;
    Outcome from_x_;
    int planned_ = 0;
};

TEST_F(SetupSearchOf, OneSetIsPlannedAndNothingWasWeighed) {
    EXPECT_TRUE(best().assignment.choices.empty());
    EXPECT_EQ(planned_, 1);
}

TEST_F(SetupSearchOf, FewerAreTakenWithoutAPlanOfMoreWhereThatCannotBeQuicker) {
    sets_.with_forms = along({kZ});
    few_ = {9, 0};
    const Plan plan = best();
    EXPECT_EQ(plan.setups.size(), 1U);
    EXPECT_EQ(planned_, 1);
    ASSERT_EQ(plan.assignment.choices.size(), 2U);
    EXPECT_EQ(plan.assignment.choices[1].verdict, SetupVerdict::CannotTakeLess);
}

TEST_F(SetupSearchOf, RidgesOfFormCuttersAreAllowedAndNoneOfSides) {
    few_ = {9, 0.001 * kRemovedMm3};
    sets_.with_forms = along({kZ});
    EXPECT_EQ(best().setups.size(), 1U);
    sets_.with_forms.clear();
    sets_.others.further = {along({kZ})};
    EXPECT_EQ(best().setups.size(), 2U);
}

TEST_F(SetupSearchOf, OtherOrdersArePlannedForLotsOfAShiftAlone) {
    sets_.others.further = {along({kX, kZ})};
    from_x_ = {8, 0};
    EXPECT_EQ(best().setups.front().setup.axis, kZ);
    EXPECT_EQ(planned_, 1);
    request_.quantity = 48;  // ten minutes each
    const Plan plan = best();
    EXPECT_EQ(plan.setups.front().setup.axis, kX);
    ASSERT_EQ(plan.assignment.choices.size(), 2U);
    EXPECT_EQ(plan.assignment.choices[0].verdict, SetupVerdict::Taken);
    EXPECT_EQ(plan.assignment.choices[0].axes.front(), kX);
    EXPECT_EQ(plan.assignment.choices[1].verdict, SetupVerdict::TakesLonger);
}

TEST_F(SetupSearchOf, OtherOrdersArePlannedWhereTwoSetupsLeaveWalls) {
    sets_.others.further = {along({kX, kZ})};
    request_.scallop_mm = 0.02;
    from_x_ = {12, 0};
    chosen_ = {10, 0.001 * kRemovedMm3};
    EXPECT_EQ(best().setups.front().setup.axis, kZ);
    chosen_ = {10, 0.003 * kRemovedMm3};
    EXPECT_EQ(best().setups.front().setup.axis, kX);
}

TEST_F(SetupSearchOf, OtherOrdersArePlannedWhereAPlanIsFarFromItsBound) {
    sets_.others.further = {along({kX, kZ})};
    from_x_ = {8, 0};
    chosen_ = {10, 0, 3};
    EXPECT_EQ(best().setups.front().setup.axis, kZ);
    chosen_.bound_minutes = 2;
    EXPECT_EQ(best().setups.front().setup.axis, kX);
}

TEST_F(SetupSearchOf, NoneIsPlannedThatTakesLongerToSetUpThanThereIsToWin) {
    sets_.others.further = {along({kX, kZ, kY})};
    machine_.setup_time_min = 18;
    from_x_ = {1, 0};
    chosen_ = {20, 0, 2};
    EXPECT_EQ(best().setups.front().setup.axis, kZ);
    EXPECT_EQ(planned_, 1);
    machine_.setup_time_min = 17;
    EXPECT_EQ(best().setups.front().setup.axis, kX);
}

TEST_F(SetupSearchOf, TheOrderOfLeastStepsIsPlannedBesideEverySmallPlan) {
    sets_.others.least_steps = along({kX, kZ});
    chosen_.bound_minutes = 5;
    from_x_ = {8, 0};
    EXPECT_EQ(best().setups.front().setup.axis, kX);
    chosen_.operations = 60;
    EXPECT_EQ(best().setups.front().setup.axis, kZ);
    request_.quantity = 48;  // ten minutes each
    EXPECT_EQ(best().setups.front().setup.axis, kX);
}

TEST_F(SetupSearchOf, ATrialThatCannotBePlannedLosesNothing) {
    sets_.others.further = {along({kX, kZ}), along({kZ, kY})};
    from_x_.fails = ErrorCode::TimedOut;
    request_.quantity = 1000;
    const Plan plan = best();
    EXPECT_EQ(plan.setups.front().setup.axis, kZ);
    EXPECT_EQ(planned_, 3);
    ASSERT_EQ(plan.assignment.choices.size(), 3U);
    EXPECT_EQ(plan.assignment.choices[1].verdict, SetupVerdict::NoTime);
    EXPECT_FALSE(plan.assignment.choices[1].planned);
    from_x_.fails = ErrorCode::GeometryKernel;
    EXPECT_EQ(best().assignment.choices[1].verdict, SetupVerdict::CannotBePlanned);
}

TEST_F(SetupSearchOf, NoOtherIsPlannedWhenTheTimeIsOver) {
    sets_.others.further = {along({kX, kZ})};
    request_.quantity = 1000;
    request_.patience.all_tools = Deadline::in(-1);
    const Plan plan = best();
    EXPECT_EQ(planned_, 1);
    ASSERT_EQ(plan.assignment.choices.size(), 2U);
    EXPECT_EQ(plan.assignment.choices[1].verdict, SetupVerdict::NoTime);
    ASSERT_FALSE(plan.warnings.empty());
    EXPECT_EQ(plan.warnings.back().code, "few-setups");
}

TEST_F(SetupSearchOf, TheChosenSetFailsAsItDoes) {
    chosen_.fails = ErrorCode::TimedOut;
    EXPECT_THROW(best(), Error);
}

}  // namespace
}  // namespace stepmill::test
