// Plans that are short of time.

#include <gtest/gtest.h>

#include <set>

#include "plan/features/few_tools.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/plan/plan.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

Plan planWith(const Patience& patience, const std::string& name) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.patience = patience;
    const Part part = readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + name).front();
    return planPart(part, request, defaultToolLibrary(), defaultMachine(), kTol);
}

bool warns(const Plan& plan, const std::string& code) {
    return std::any_of(plan.warnings.begin(), plan.warnings.end(),
                       [&](const Warning& warning) { return warning.code == code; });
}

std::set<std::string> millsOf(const Plan& plan) {
    std::set<std::string> mills;
    for (const PlannedSetup& setup : plan.setups)
        for (const Operation& operation : setup.operations)
            if (operation.role != Role::Drill) mills.insert(operation.tool_id);
    return mills;
}

TEST(Patience, IsWithoutEndUnlessAskedFor) {
    const Patience none;
    EXPECT_FALSE(none.allToolsOfOne().passed());
    EXPECT_FALSE(patienceFor(std::numeric_limits<double>::infinity()).fewToolsOfOne().passed());
}

TEST(Patience, LeavesNothingForToolsWhereTheTimeIsOver) {
    const Patience over = patienceFor(0);
    EXPECT_TRUE(over.allToolsOfOne().passed());
    EXPECT_TRUE(over.fewToolsOfOne().passed());
}

TEST(Patience, AfterwardsAllToolsAreWeighedOnlyWhereThereWasTime) {
    Patience before = patienceFor(1000);
    EXPECT_FALSE(patienceAfter(before).all_tools.passed());
    before.all_tools = Deadline::in(0);
    const Patience after = patienceAfter(before);
    EXPECT_TRUE(after.all_tools.passed());
    EXPECT_GT(after.few_tools.secondsLeft(), 100);
    EXPECT_LT(after.few_tools.secondsLeft(), before.end.secondsLeft());
}

TEST(Patience, ASetupLeavesTimeToThoseThatFollow) {
    const Patience all = patienceFor(1000);
    EXPECT_GT(all.ofOneSetup(0).all_tools.secondsLeft(), 0.99 * all.all_tools.secondsLeft());
    const Patience first = all.ofOneSetup(2);
    EXPECT_LT(first.all_tools.secondsLeft(), 0.7 * all.all_tools.secondsLeft());
    EXPECT_LT(first.few_tools.secondsLeft(), 0.7 * all.few_tools.secondsLeft());
    EXPECT_GT(first.few_tools.secondsLeft(), first.all_tools.secondsLeft());
    EXPECT_TRUE(patienceFor(std::numeric_limits<double>::infinity()).ofOneSetup(2).all_tools.isNever());
    EXPECT_TRUE(Patience{}.ofOneSetup(2).few_tools.isNever());
}

TEST(Patience, FewToolsArePlannedWithWhereAllTakeTooLong) {
    const Plan plan = planWith({Deadline::in(0), {}, {}}, "four_setups.step");
    EXPECT_TRUE(warns(plan, "few-tools"));
    EXPECT_FALSE(warns(plan, "books"));
    const ToolLibrary few = fewTools(defaultToolLibrary(), "aluminium");
    std::set<std::string> known;
    for (const ToolAssembly& tool : few.tools)
        known.insert(tool.id);
    const std::set<std::string> used = millsOf(plan);
    EXPECT_FALSE(used.empty());
    for (const std::string& mill : used)
        EXPECT_EQ(known.count(mill), 1U) << mill;
    const Plan best = planWith({}, "four_setups.step");
    EXPECT_LT(plan.totals.lower_bound_s, best.totals.lower_bound_s);
    EXPECT_GT(plan.balance.planned_mm3, 0.9 * best.balance.planned_mm3);
}

TEST(Patience, FeaturesWithoutAnyTimeStay) {
    const Plan plan = planWith(patienceFor(0), "four_setups.step");
    EXPECT_FALSE(warns(plan, "books"));
    EXPECT_FALSE(plan.complete(kTol));
    EXPECT_TRUE(millsOf(plan).empty());
    for (const PlannedSetup& setup : plan.setups)
        for (const PlannedFeature& planned : setup.features)
            for (const Residual& residual : planned.sequence.residual)
                EXPECT_TRUE(residual.reason == Reason::TimeLimit || residual.reason == Reason::BelowStanding)
                    << toString(residual.reason);
}

TEST(FewTools, AreTheWidestTheNarrowestAndSomeBetween) {
    const ToolLibrary all = defaultToolLibrary();
    const ToolLibrary few = fewTools(all, "aluminium");
    double widest_mm = 0;
    double narrowest_mm = 1e9;
    std::size_t mills = 0;
    for (const ToolAssembly& tool : few.tools) {
        if (tool.isDrill() || tool.isTap()) continue;
        ++mills;
        widest_mm = std::max(widest_mm, tool.diameter_mm);
        narrowest_mm = std::min(narrowest_mm, tool.diameter_mm);
    }
    EXPECT_EQ(mills, kFewMills);
    for (const ToolAssembly& tool : all.tools) {
        if (tool.isDrill() || tool.isForm()) continue;
        EXPECT_LE(tool.diameter_mm, widest_mm);
        EXPECT_GE(tool.diameter_mm, narrowest_mm);
    }
}

TEST(FewTools, OfASmallLibraryAreAll) {
    ToolLibrary small = defaultToolLibrary();
    small.tools.resize(3);
    EXPECT_EQ(fewTools(small, "aluminium").tools.size(), 3U);
}

}  // namespace
}  // namespace stepmill
