// Whole plans in which nested features are cut together.

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/planar/clearance_diagram.h"
#include "stepmill/proven/proven_plan.h"
#include "stepmill/verify/claim.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

Part samplePart(const std::string& name) {
    return readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + name + ".step").front();
}

ProvenPlan planned(const Part& part, bool common_ground) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.common_ground = common_ground;
    return planProven(part, request, defaultToolLibrary(), defaultMachine(), kTol);
}

int groundsOf(const Plan& plan) {
    int count = 0;
    for (const PlannedSetup& setup : plan.setups)
        for (const PlannedFeature& planned : setup.features)
            count += planned.feature.ground_of.empty() ? 0 : 1;
    return count;
}

class CutTogether : public testing::TestWithParam<const char*> {};

void expectItFollows(const Part& part, const ProvenPlan& plan) {
    const PlanRecord record = planRecordFromText(plan.files.plan_json, kTol);
    for (const ProofFailure& failure :
         compareWithPart(record, {part, defaultToolLibrary(), {}, {}, {}}, kTol))
        ADD_FAILURE() << failure.operation << ": " << failure.text;
}

TEST_P(CutTogether, IsProvenQuickerLeavesNoMoreAndFollowsFromPartAndLibrary) {
    const Part part = samplePart(GetParam());
    const ProvenPlan together = planned(part, true);
    const ProvenPlan apart = planned(part, false);
    EXPECT_GT(groundsOf(together.plan), 0);
    EXPECT_EQ(groundsOf(apart.plan), 0);
    EXPECT_TRUE(together.mayRun());
    EXPECT_LT(together.plan.totals.motion_s, apart.plan.totals.motion_s);
    EXPECT_GE(together.plan.balance.planned_mm3, apart.plan.balance.planned_mm3 - kVolumeRoundingMm3);
    expectItFollows(part, together);
}

/// What is said of the plan of a part when its common ground was changed.
std::vector<ProofFailure> saidOf(const Part& part, const ProvenPlan& plan,
                                 const std::function<void(Feature& ground)>& change) {
    PlanRecord record = planRecordFromText(plan.files.plan_json, kTol);
    for (auto& [id, recorded] : record.features)
        if (!recorded.feature.ground_of.empty()) change(recorded.feature);
    return compareWithPart(record, {part, defaultToolLibrary(), {}, {}, {}}, kTol);
}

TEST(ChangedGround, IsNotWhatThePartSays) {
    const Part part = samplePart("die_cavity");
    const ProvenPlan plan = planned(part, true);
    EXPECT_TRUE(saidOf(part, plan, [](Feature&) {}).empty());
    EXPECT_FALSE(saidOf(part, plan, [](Feature& ground) { ground.ground_of.clear(); }).empty());
    EXPECT_FALSE(saidOf(part, plan, [](Feature& ground) { ground.ground_of.pop_back(); }).empty());
    EXPECT_FALSE(saidOf(part, plan, [](Feature& ground) { ground.obstruction = {}; }).empty());
    EXPECT_FALSE(
        saidOf(part, plan, [](Feature& ground) { ground.target = offset(ground.target, 1, kTol); }).empty());
    EXPECT_FALSE(
        saidOf(part, plan, [](Feature& ground) { ground.target = offset(ground.target, -1, kTol); }).empty());
}

INSTANTIATE_TEST_SUITE_P(Parts, CutTogether, testing::Values("die_cavity"));

}  // namespace
}  // namespace stepmill
