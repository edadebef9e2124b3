// Times that a plan is to take: paces, the rule for wider tools, what is told.

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/plan/plan.h"
#include "stepmill/plan/sequence_memory.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

/// Plans of one sample for one time after another.
class CycleTimePlan : public testing::Test {
  protected:
    void SetUp() override {
        part_ = readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/plate_with_holes.step").front();
        request_.sequence.material = "aluminium";
        request_.sequence.retract_mm = defaultMachine().safe_height_mm;
        request_.sequence.cut_material = *defaultMaterials().find("aluminium");
    }

    Plan planFor(const std::vector<CycleTarget>& targets) {
        PlanRequest request = request_;
        request.cycle_times = targets;
        return planPart(part_, request, defaultToolLibrary(), defaultMachine(), kTol, {}, memory_);
    }

    double usualS() { return planFor({}).totals.motion_s; }

    Part part_;
    PlanRequest request_;
    SequenceMemory memory_;
};

TEST_F(CycleTimePlan, KeepsAnyTimeBetweenItsBoundsToOnePercentAndNoLonger) {
    const double usual_s = usualS();
    const double least_s = planFor({{"", 0.1 * usual_s}}).cycle.outcomes.front().bound_s;
    const double most_s = planFor({{"", 10 * usual_s}}).cycle.outcomes.front().bound_s;
    ASSERT_LT(least_s, usual_s);
    ASSERT_GT(most_s, usual_s);
    double before_s = 0;
    double pace_before = kFastestPace;
    for (int i = 0; i <= 12; ++i) {
        const double target_s = least_s + (most_s - least_s) * i / 12;
        const Plan plan = planFor({{"", target_s}});
        const CycleOutcome& outcome = plan.cycle.outcomes.front();
        EXPECT_TRUE(outcome.isMet()) << target_s << " s asked for, " << outcome.time_s << " s";
        EXPECT_LE(outcome.time_s, target_s * (1 + 1e-9));
        EXPECT_EQ(outcome.time_s, plan.totals.motion_s);
        EXPECT_GE(outcome.time_s, before_s) << "a longer time is no shorter plan";
        EXPECT_LE(outcome.pace, pace_before);
        before_s = outcome.time_s;
        pace_before = outcome.pace;
    }
}

TEST_F(CycleTimePlan, SaysSoWhereATimeIsOutOfReach) {
    const double usual_s = usualS();
    const Plan hasty = planFor({{"", 0.2 * usual_s}});
    const CycleOutcome& least = hasty.cycle.outcomes.front();
    EXPECT_FALSE(least.isMet());
    EXPECT_TRUE(least.isTooLong());
    EXPECT_EQ(least.pace, kFastestPace);
    EXPECT_EQ(least.time_s, least.bound_s);
    EXPECT_LE(hasty.totals.lower_bound_s, hasty.totals.time_s);
    double uses_s = 0;
    for (const UsedTime& used : least.uses)
        uses_s += used.time_s;
    EXPECT_NEAR(uses_s, least.time_s, 0.4) << "each is told from 0.05 s on";

    const CycleOutcome most = planFor({{"", 20 * usual_s}}).cycle.outcomes.front();
    EXPECT_FALSE(most.isMet());
    EXPECT_FALSE(most.isTooLong());
    EXPECT_EQ(most.pace, kSlowestPace);
}

TEST_F(CycleTimePlan, LongerTimesTakeSpeedAndPowerBack) {
    const Plan usual = planFor({});
    const Plan slow = planFor({{"", 1.2 * usual.totals.motion_s}});
    ASSERT_EQ(usual.setups.size(), slow.setups.size());
    const double pace = slow.cycle.outcomes.front().pace;
    for (std::size_t s = 0; s < usual.setups.size(); ++s)
        for (std::size_t i = 0; i < usual.setups[s].operations.size(); ++i) {
            const Operation& was = usual.setups[s].operations[i];
            const Operation& is = slow.setups[s].operations[i];
            EXPECT_EQ(is.pace, pace);
            EXPECT_NEAR(is.speed_rpm, pace * was.speed_rpm, 1e-6);
            EXPECT_NEAR(is.path.feed_mm_per_min, pace * was.path.feed_mm_per_min, 1e-6);
            EXPECT_LE(is.cuts.peak_kw, was.cuts.peak_kw);
        }
}

TEST_F(CycleTimePlan, NarrowerTimesComeFirstAndLeaveTheOthersTheRest) {
    const Plan usual = planFor({});
    const std::string setup = usual.setups.front().setup.id;
    const std::string feature = usual.setups.front().operations.front().feature_id;
    const CycleOutcome alone = planFor({{feature, 1e4}}).cycle.outcomes.front();
    const double feature_s = 0.5 * (alone.planned_s + alone.bound_s);
    const double part_s = 1.1 * (usual.totals.motion_s + feature_s - alone.planned_s);
    const Plan plan = planFor({{"", part_s}, {feature, feature_s}});
    EXPECT_TRUE(plan.cycle.areMet());
    EXPECT_NE(plan.cycle.outcomes[0].pace, plan.cycle.outcomes[1].pace);
    const Plan of_setup = planFor({{setup, 1.1 * usual.setups.front().motion_s}});
    EXPECT_TRUE(of_setup.cycle.areMet());
    for (std::size_t s = 1; s < usual.setups.size(); ++s)
        EXPECT_EQ(of_setup.setups[s].motion_s, usual.setups[s].motion_s);
}

TEST_F(CycleTimePlan, WantsNamesThatThePlanHas) {
    try {
        planFor({{"S9.F1", 60}});
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::Usage);
        EXPECT_EQ(error.subject(), "--cycle-time S9.F1");
    }
}

TEST_F(CycleTimePlan, WithoutACuttingModelNothingIsFedFaster) {
    request_.sequence.cut_material.reset();
    const CycleOutcome hasty = planFor({{"", 1}}).cycle.outcomes.front();
    EXPECT_EQ(hasty.bound_s, hasty.planned_s);
    EXPECT_EQ(hasty.pace, 1);
    const double usual_s = hasty.planned_s;
    EXPECT_TRUE(planFor({{"", 1.1 * usual_s}}).cycle.areMet());
}

TEST_F(CycleTimePlan, TriesOtherToolsWhereFeedsDoNotDo) {
    PlanRequest request = request_;
    request.cycle_times = {{"", 0.2 * usualS()}};
    const PlanOfRequest found =
        planToTime(part_, request, defaultToolLibrary(), defaultMachine(), kTol, {}, memory_);
    const CycleTimes& cycle = found.plan.cycle;
    ASSERT_FALSE(cycle.steps.empty());
    EXPECT_EQ(cycle.steps.front().way, CycleWay::Feeds);
    const auto tried = [&](CycleWay way) {
        return std::any_of(cycle.steps.begin(), cycle.steps.end(),
                           [&](const CycleStep& step) { return step.way == way; });
    };
    EXPECT_TRUE(tried(CycleWay::Sequence));
    double time_s = cycle.steps.front().before_s;
    for (const CycleStep& step : cycle.steps) {
        EXPECT_LE(step.before_s, time_s + 1e-9);
        if (!step.taken) continue;
        EXPECT_LT(step.after_s, step.before_s);
        time_s = step.after_s;
    }
    EXPECT_NEAR(cycle.outcomes.front().time_s, time_s, 1e-9);
    EXPECT_TRUE(found.plan.complete(kTol));
    // The request makes the same plan again.
    const Plan again =
        planPart(part_, found.request, defaultToolLibrary(), defaultMachine(), kTol, {}, memory_);
    EXPECT_EQ(again.totals.motion_s, found.plan.totals.motion_s);
}

TEST_F(CycleTimePlan, TakesWiderToolsWhereMoneyChoseNarrowOnes) {
    part_ = readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/rounded_pocket.step").front();
    request_.sequence.objective = Objective::Cost;
    ToolLibrary library = defaultToolLibrary();
    constexpr double kCheapUpToMm = 5;
    for (ToolAssembly& tool : library.tools) {
        tool.life_min = 1;
        tool.price = tool.diameter_mm > kCheapUpToMm ? 1e4 : 0;
    }
    const auto search = [&](const std::vector<CycleTarget>& targets) {
        PlanRequest request = request_;
        request.cycle_times = targets;
        return planToTime(part_, request, library, defaultMachine(), kTol, {}, memory_).plan;
    };
    const double usual_s = search({}).totals.motion_s;
    const Plan plan = search({{"", 0.4 * usual_s}});
    EXPECT_TRUE(plan.cycle.areMet()) << plan.totals.motion_s << " s of " << usual_s;
    const auto taken =
        std::find_if(plan.cycle.steps.begin(), plan.cycle.steps.end(),
                     [](const CycleStep& step) { return step.way == CycleWay::Diameter && step.taken; });
    ASSERT_NE(taken, plan.cycle.steps.end());
    EXPECT_GT(taken->wanted_mm, 0);
    EXPECT_GT(taken->diameter_mm, kCheapUpToMm);
    EXPECT_GE(taken->diameter_mm, taken->wanted_mm);
    EXPECT_LT(taken->after_s, taken->before_s);
    const std::string& first = plan.setups.front().operations.front().tool_id;
    EXPECT_GE(library.tool(first).diameter_mm, taken->diameter_mm);
    EXPECT_TRUE(plan.complete(kTol));
}

// The rule for wider tools ---------------------------------------------------------------------------------

TEST(WiderCutter, WantsAreaOverTimeAndFeed) {
    EXPECT_NEAR(wantedDiameterMm({10000, 30, 2000, 80}), 10, 1e-9);
}

TEST(WiderCutter, TakesTheFirstWhosePassesAreMoreThanHalfAPassOver) {
    // 80 / 6 = 13.3, 80 / 7 = 11.4, 80 / 8.5 = 9.4, 80 / 10.5 = 7.6: eight passes.
    const auto found = widerCutter({10000, 30, 2000, 80}, {{20, 10.5}, {12, 6}, {14, 7}, {16, 8.5}, {8, 5}});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->diameter_mm, 20);
    EXPECT_EQ(found->passes, 8);
}

TEST(WiderCutter, TakesWholePassesAsTheyAre) {
    const auto found = widerCutter({10000, 30, 2000, 80}, {{16, 8}, {20, 10.5}});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->diameter_mm, 16);
    EXPECT_EQ(found->passes, 10);
}

TEST(WiderCutter, TakesTheNarrowestWhereTheRuleKnowsNone) {
    const auto found = widerCutter({10000, 30, 2000, 80}, {{14, 7}, {12, 6}});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->diameter_mm, 12);
    EXPECT_EQ(found->passes, 14);
}

TEST(WiderCutter, NeedsOnePassWhereItIsAsWideAsTheGround) {
    const auto found = widerCutter({10000, 30, 2000, 8}, {{12, 10}});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->passes, 1);
}

TEST(WiderCutter, IsNoneWhereAllAreNarrower) {
    EXPECT_FALSE(widerCutter({10000, 30, 2000, 80}, {{8, 4}}));
}

}  // namespace
}  // namespace stepmill
