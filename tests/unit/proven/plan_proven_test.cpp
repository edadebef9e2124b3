// What happens to a plan when proofs of its programs fail: the provers here say so, whatever the programs
// are.

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/proven/proven_plan.h"
#include "stepmill/record/plan_json.h"
#include "support/plan_bands.h"

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

const Part& nestedPockets() {
    static const Part part =
        readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/nested_pockets.step").front();
    return part;
}

ProvenPlan planWith(const Prover& prover, const ToolLibrary& library = defaultToolLibrary(),
                    const Patience& patience = {}) {
    PlanRequest request;
    request.patience = patience;
    request.sequence.material = "aluminium";
    request.sequence.retract_mm = defaultMachine().safe_height_mm;
    return planProven(nestedPockets(), request, library, defaultMachine(), Tolerances(), {}, prover);
}

Verification allProven(const PlanFiles&, const Tolerances&) {
    return {};
}

/// Operations of plan.json in one feature.
std::vector<Json> operationsOf(const PlanFiles& files, const std::string& feature) {
    std::vector<Json> found;
    const Json plan = Json::parse(files.plan_json);
    for (const Json& operation : plan["operations"])
        if (operation["feature"] == feature) found.push_back(operation);
    return found;
}

/// Says of every operation of the feature that a condition holds for that it gouges.
Prover failsIn(const std::string& feature, const std::function<bool(const Json& operation)>& condition) {
    return [=](const PlanFiles& files, const Tolerances&) {
        Verification verification;
        for (const Json& operation : operationsOf(files, feature))
            if (condition(operation))
                verification.failures.push_back({"S1.ngc", 12, operation["id"], "the holder gouges"});
        return verification;
    };
}

std::set<std::string> toolsOf(const ProvenPlan& proven, const std::string& feature) {
    std::set<std::string> tools;
    for (const Json& operation : operationsOf(proven.files, feature))
        tools.insert(operation["tool"].get<std::string>());
    return tools;
}

std::vector<Warning> warningsOf(const ProvenPlan& proven) {
    std::vector<Warning> found;
    for (const Warning& warning : proven.plan.warnings)
        if (warning.code == "proof") found.push_back(warning);
    return found;
}

const PlannedFeature& featureOf(const ProvenPlan& proven, const std::string& id) {
    for (const PlannedSetup& setup : proven.plan.setups)
        for (const PlannedFeature& planned : setup.features)
            if (planned.feature.id == id) return planned;
    throw std::out_of_range(id);
}

/// A feature that the plan mills, with others below it.
const std::string kParent = "S1.F1";
/// One whose second tool comes down in several places by rapids into what the first has cleared.
const std::string kRest = "S1.F3";

TEST(PlanProven, IsThePlanAsItIsWhereAllIsProven) {
    const ProvenPlan proven = planWith(allProven);
    EXPECT_TRUE(proven.verification.proven());
    EXPECT_TRUE(warningsOf(proven).empty());
    EXPECT_EQ(proven.files.plan_json, planJson(proven.plan));
    EXPECT_FALSE(operationsOf(proven.files, kParent).empty());
}

TEST(PlanProven, TakesPlainRapidsFirst) {
    const std::string before = planWith(allProven).files.programs.at("S1").front().text;
    int calls = 0;
    const ProvenPlan proven = planWith([&](const PlanFiles& files, const Tolerances& tol) {
        return ++calls > 1 ? Verification{} : failsIn(kRest, [](const Json&) { return true; })(files, tol);
    });
    EXPECT_EQ(calls, 2);
    EXPECT_TRUE(proven.verification.proven());
    EXPECT_TRUE(proven.files.programs.at("S1").front().text != before);
    ASSERT_EQ(warningsOf(proven).size(), 1u);
    EXPECT_EQ(warningsOf(proven).front().subject, kRest);
    EXPECT_TRUE(verifyPlan(proven.files, Tolerances()).proven());
}

/// Mills that rough at constant engagement, for all else they go in many shallow cuts.
ToolLibrary roughingLibrary() {
    ToolLibrary library = defaultToolLibrary();
    for (ToolAssembly& tool : library.tools)
        for (CuttingData& cutting : tool.cutting) {
            if (tool.type != ToolType::Flat) continue;
            cutting.step_down_mm = cutting.slot_step_down_mm = 0.05 * tool.diameter_mm;
            cutting.adaptive =
                AdaptiveData{0.15 * tool.diameter_mm, tool.flute_length_mm, cutting.feed_mm_per_min, 0, 0};
        }
    return library;
}

TEST(PlanProven, GoesOnWithoutConstantEngagementWhereThatFails) {
    const ToolLibrary library = roughingLibrary();
    const auto engages = [](const Json& operation) { return operation.value("engagement_deg", 0.0) > 0; };
    const auto any_adaptive = [&](const ProvenPlan& proven) {
        const std::vector<Json> operations = operationsOf(proven.files, kParent);
        return std::any_of(operations.begin(), operations.end(), engages);
    };
    ASSERT_TRUE(any_adaptive(planWith(allProven, library)));
    const ProvenPlan proven = planWith(failsIn(kParent, engages), library);
    EXPECT_FALSE(any_adaptive(proven));
    EXPECT_FALSE(operationsOf(proven.files, kParent).empty());
    ASSERT_EQ(warningsOf(proven).size(), 1u);
    EXPECT_NE(warningsOf(proven).front().text.find("without constant engagement"), std::string::npos);
    EXPECT_TRUE(verifyPlan(proven.files, Tolerances()).proven());
}

TEST(PlanProven, GoesOnWithoutAToolThatFails) {
    const std::string tool = *toolsOf(planWith(allProven), kParent).begin();
    const ProvenPlan proven =
        planWith(failsIn(kParent, [&](const Json& operation) { return operation["tool"] == tool; }));
    EXPECT_TRUE(proven.verification.proven());
    EXPECT_FALSE(toolsOf(proven, kParent).empty());
    EXPECT_EQ(toolsOf(proven, kParent).count(tool), 0u);
    EXPECT_TRUE(verifyPlan(proven.files, Tolerances()).proven());
}

TEST(PlanProven, DropsAFeatureThatNoToolIsProvenIn) {
    const ProvenPlan proven = planWith(failsIn(kParent, [](const Json&) { return true; }));
    EXPECT_TRUE(proven.verification.proven());
    EXPECT_TRUE(operationsOf(proven.files, kParent).empty());
    const PlannedFeature& dropped = featureOf(proven, kParent);
    ASSERT_EQ(dropped.sequence.residual.size(), 1u);
    EXPECT_EQ(dropped.sequence.residual.front().reason, Reason::NotProven);
    EXPECT_DOUBLE_EQ(dropped.sequence.residual.front().volume_mm3, dropped.feature.volume_mm3);
    EXPECT_FALSE(proven.plan.complete(Tolerances()));
    EXPECT_LE(proven.plan.balance.gapShare(), Tolerances().volume_share);
    EXPECT_TRUE(verifyPlan(proven.files, Tolerances()).proven()) << "what lies below it is not cut either";
}

TEST(PlanProven, DropsWhatFailedAtOnceWhereTimeIsShort) {
    int calls = 0;
    const auto failing = failsIn(kRest, [](const Json&) { return true; });
    const Patience short_of_time{{}, {}, Deadline::in(0)};
    const ProvenPlan proven = planWith(
        [&](const PlanFiles& files, const Tolerances& tol) {
            ++calls;
            return failing(files, tol);
        },
        defaultToolLibrary(), short_of_time);
    EXPECT_EQ(calls, 2);
    EXPECT_TRUE(proven.verification.proven());
    EXPECT_TRUE(operationsOf(proven.files, kRest).empty());
    EXPECT_FALSE(operationsOf(proven.files, kParent).empty()) << "what is known needs no time";
    EXPECT_EQ(featureOf(proven, kRest).sequence.residual.front().reason, Reason::NotProven);
    EXPECT_TRUE(verifyPlan(proven.files, Tolerances()).proven());
}

TEST(PlanProven, NamesWhatToolsLeaveWhereOnlyThatFails) {
    const Region left = makeRectangle({10, 10}, {12, 11});
    const Prover leaves = [&](const PlanFiles& files, const Tolerances&) {
        Verification verification;
        const Json plan = Json::parse(files.plan_json);
        for (const test::BandOfPlan& one : test::bandsOf(plan))
            for (const Json& residual : one.band["residual"])
                if (residual["reason"] == "proof") return verification;
        const Json operation = operationsOf(files, kParent).back();
        verification.failures.push_back({"S1.ngc", 12, operation["id"], "leaves 2 mm2"});
        verification.leftovers.push_back({"S1", kParent, left, area(left), 5, 3000});
        return verification;
    };
    const ProvenPlan proven = planWith(leaves);
    EXPECT_TRUE(proven.verification.proven());
    EXPECT_FALSE(operationsOf(proven.files, kParent).empty());
    EXPECT_NEAR(residualVolumeMm3(featureOf(proven, kParent).sequence), 10, 1e-6);
    EXPECT_LE(proven.plan.balance.gapShare(), Tolerances().volume_share);
}

TEST(PlanProven, StaysUnprovenWhereNoOperationIsToBlame) {
    const ProvenPlan proven = planWith([](const PlanFiles&, const Tolerances&) {
        Verification verification;
        verification.failures.push_back({"S1.ngc", 3, "", "cannot be read"});
        return verification;
    });
    EXPECT_FALSE(proven.verification.proven());
}

}  // namespace
}  // namespace stepmill
