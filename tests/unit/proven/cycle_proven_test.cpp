// Plans that were driven or slowed for a cycle time, and their proof.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/proven/proven_plan.h"
#include "stepmill/verify/claim.h"

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

ProvenPlan planFor(double time_s) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.sequence.retract_mm = defaultMachine().safe_height_mm;
    request.sequence.cut_material = *defaultMaterials().find("aluminium");
    if (time_s > 0) request.cycle_times = {{"", time_s}};
    const Part part = readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/rounded_pocket.step").front();
    return planProven(part, request, defaultToolLibrary(), defaultMachine(), Tolerances());
}

double usualS() {
    static const double usual_s = planFor(0).plan.totals.motion_s;
    return usual_s;
}

const ProvenPlan& driven() {
    static const ProvenPlan proven = planFor(0.97 * usualS());
    return proven;
}

PlanFiles withPlan(PlanFiles files, const std::function<void(Json&)>& change) {
    Json plan = Json::parse(files.plan_json);
    change(plan);
    files.plan_json = plan.dump();
    return files;
}

void expectHolds(const ProvenPlan& proven) {
    ASSERT_TRUE(proven.verification.proven()) << proven.verification.failures.front().text;
    EXPECT_TRUE(proven.plan.cycle.areMet());
    const PlanRecord record = planRecordFromText(proven.files.plan_json, Tolerances());
    for (const ProofFailure& failure : compareWithLibrary(record, defaultToolLibrary()))
        ADD_FAILURE() << failure.operation << ": " << failure.text;
    ASSERT_EQ(record.cycle.outcomes.size(), 1U);
    EXPECT_NEAR(record.cycle.outcomes.front().time_s, proven.plan.totals.motion_s, 1e-5);
    EXPECT_EQ(record.request->cycle_times.size(), 1U);
    EXPECT_EQ(record.cycle.steps.size(), proven.plan.cycle.steps.size());
}

TEST(CycleProven, DrivenFasterItsCutsAreStillWithinWhatTheLibraryAndSpindleGive) {
    expectHolds(driven());
    EXPECT_GT(driven().plan.cycle.outcomes.front().pace, 1);
}

TEST(CycleProven, SlowedItIsProvenToo) {
    expectHolds(planFor(1.25 * usualS()));
}

TEST(CycleProven, FeedsThatNoPaceAllowsAreFound) {
    const PlanFiles usual = withPlan(driven().files, [](Json& plan) {
        for (Json& operation : plan["operations"])
            operation.erase("pace");
    });
    EXPECT_FALSE(verifyPlan(usual, Tolerances()).proven()) << "the cuts are faster than the library's feeds";
}

TEST(CycleProven, PacesAreRefusedWhereNoTimeWasAskedFor) {
    const PlanFiles unasked = withPlan(driven().files, [](Json& plan) {
        plan["request"].erase("cycle_times");
        plan.erase("cycle_time");
    });
    EXPECT_THROW(planRecordFromText(unasked.plan_json, Tolerances()), Error);
    const PlanFiles beyond = withPlan(driven().files, [](Json& plan) {
        for (Json& operation : plan["operations"])
            if (operation.contains("pace")) operation["pace"] = 1.6;
    });
    EXPECT_THROW(planRecordFromText(beyond.plan_json, Tolerances()), Error);
}

}  // namespace
}  // namespace stepmill
