// Plans with a hole table, and proofs of their programs.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/proven/proven_plan.h"
#include "stepmill/verify/claim.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

using test::kTol;
const std::string kSource = STEPMILL_SOURCE_DIR;

const Part& plate() {
    static const Part part = readStep(kSource + "/step_parts/plate_with_holes.step").front();
    return part;
}

ToolLibrary shopWithTaps() {
    return readToolLibrary(kSource + "/samples/shop_with_taps_tools.json");
}

ProvenPlan planWith(const HoleTable& table, const ToolLibrary& library,
                    const Machine& machine = defaultMachine()) {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.sequence.retract_mm = machine.safe_height_mm;
    request.holes = table;
    return planProven(plate(), request, library, machine, kTol);
}

HoleTable tableOf(const std::string& entries) {
    return holeTableFromText(R"({"format": 1, "unit": "mm", "holes": [)" + entries + "]}", "holes.json");
}

/// The plan of samples/plate_holes.json.
const ProvenPlan& threaded() {
    static const ProvenPlan proven =
        planWith(readHoleTable(kSource + "/samples/plate_holes.json"), shopWithTaps());
    return proven;
}

std::vector<const Operation*> tappingOf(const Plan& plan) {
    std::vector<const Operation*> tapping;
    for (const PlannedSetup& setup : plan.setups)
        for (const Operation& operation : setup.operations)
            if (operation.role == Role::Tap) tapping.push_back(&operation);
    return tapping;
}

std::vector<Warning> warningsOf(const Plan& plan, const std::string& code) {
    std::vector<Warning> found;
    for (const Warning& warning : plan.warnings)
        if (warning.code == code) found.push_back(warning);
    return found;
}

/// What the proof says of the files with one text in plan.json or the program changed.
std::vector<ProofFailure> failuresWith(const std::string& text, const std::string& other, bool in_plan) {
    PlanFiles files = threaded().files;
    std::string& changed = in_plan ? files.plan_json : files.programs.begin()->second.front().text;
    const std::size_t at = changed.find(text);
    EXPECT_NE(at, std::string::npos) << text;
    changed.replace(at, text.size(), other);
    return verifyPlan(files, kTol).failures;
}

bool anySays(const std::vector<ProofFailure>& failures, const std::string& words) {
    return std::any_of(failures.begin(), failures.end(), [&](const ProofFailure& failure) {
        return failure.text.find(words) != std::string::npos;
    });
}

TEST(ThreadsProven, AreCutWhereTheTableAsksAndProven) {
    const ProvenPlan& proven = threaded();
    EXPECT_TRUE(proven.mayRun());
    EXPECT_TRUE(proven.plan.complete(kTol));
    EXPECT_TRUE(proven.verification.proven());
    const std::vector<const Operation*> tapping = tappingOf(proven.plan);
    ASSERT_EQ(tapping.size(), 2U);
    int eights = 0;
    int tens = 0;
    for (const Operation* operation : tapping) {
        ASSERT_TRUE(operation->thread);
        (operation->thread->thread.name == "M8x1.25" ? eights : tens) += operation->holes;
        EXPECT_EQ(operation->thread->full_to_z_mm, operation->holes == 6 ? -10 : -8);
        EXPECT_EQ(operation->path.feed_mm_per_min, operation->thread->thread.pitch_mm * operation->speed_rpm);
    }
    EXPECT_EQ(eights, 6);
    EXPECT_EQ(tens, 4);
    EXPECT_TRUE(warningsOf(proven.plan, "hole-table").empty());
}

TEST(ThreadsProven, ComeAfterTheDrillOfTheirHolesAndChangeNoBooks) {
    const ProvenPlan plain = planWith({}, shopWithTaps());
    const ProvenPlan& proven = threaded();
    EXPECT_TRUE(tappingOf(plain.plan).empty());
    EXPECT_EQ(plain.plan.balance.planned_mm3, proven.plan.balance.planned_mm3);
    EXPECT_EQ(proven.plan.balance.gapMm3(), plain.plan.balance.gapMm3());
    for (const PlannedSetup& setup : proven.plan.setups) {
        std::set<std::string> drilled;
        for (const Operation& operation : setup.operations) {
            if (operation.role == Role::Tap) {
                EXPECT_EQ(drilled.count(operation.feature_id), 1U) << operation.id;
            }
            drilled.insert(operation.feature_id);
        }
    }
}

TEST(ThreadsProven, APitchADepthOrATapThatWasEditedIsFound) {
    EXPECT_TRUE(anySays(failuresWith("K1.25", "K1.26", false), "the pitch of M8x1.25"));
    EXPECT_TRUE(anySays(failuresWith("G33.1 Z-16.2500", "G33.1 Z-17.0000", false), "goes down to Z-17"));
    EXPECT_TRUE(anySays(failuresWith("G33.1 Z-16.2500", "G33.1 Z-15.0000", false), "planned is Z-16.2500"));
    EXPECT_TRUE(anySays(failuresWith("\"full_to_z_mm\": -10", "\"full_to_z_mm\": -12", true),
                        "its thread cannot be whole down to Z-12"));
}

TEST(ThreadsProven, FanucProgramsOfTheSamePlanAreProvenToo) {
    const PlanRecord record = planRecordFromText(threaded().files.plan_json, kTol);
    PlanFiles fanuc{threaded().files.plan_json, Dialect::Fanuc, {}};
    for (const RecordedSetup& setup : record.setups)
        fanuc.programs[setup.id] =
            post(jobOf(record, setup, readPrograms(threaded().files, setup)), {Dialect::Fanuc});
    EXPECT_TRUE(verifyPlan(fanuc, kTol).proven());
    std::string& text = fanuc.programs.begin()->second.front().text;
    const std::size_t at = text.find("F1000.00");
    ASSERT_NE(at, std::string::npos);
    text.replace(at, 8, "F1000.10");
    EXPECT_TRUE(anySays(verifyPlan(fanuc, kTol).failures, "goes 1.250125 mm a turn at S800"));
}

/// The first tapping operation, and its tool.
Json& tapping(Json& plan) {
    return *std::find_if(plan["operations"].begin(), plan["operations"].end(),
                         [](const Json& one) { return one["role"] == "tap"; });
}
Json& tapOf(Json& plan) {
    return *std::find_if(plan["tools"].begin(), plan["tools"].end(),
                         [&](const Json& one) { return one["id"] == tapping(plan)["tool"]; });
}

/// Is the plan refused, or not proven by its programs or the library?
bool isCaught(const Json& plan) {
    PlanFiles files = threaded().files;
    files.plan_json = plan.dump();
    try {
        const PlanRecord record = planRecordFromText(files.plan_json, kTol);
        return !verifyPlan(files, kTol).proven() || !compareWithLibrary(record, shopWithTaps()).empty();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::InvalidCatalog);
        return true;
    }
}

TEST(ThreadsProven, APlanThatWasWeakenedIsCaught) {
    const std::vector<std::pair<const char*, void (*)(Json&)>> weakenings{
        {"shorter lead", [](Json& plan) { tapOf(plan)["lead_mm"] = 1; }},
        {"longer reach", [](Json& plan) { tapOf(plan)["flute_length_mm"] = 50; }},
        {"another thread",
         [](Json& plan) { tapOf(plan)["thread"] = tapping(plan)["thread"]["name"] = "M10x1"; }},
        {"no thread at all", [](Json& plan) { tapOf(plan)["thread"] = std::string(100000, 'M'); }},
        {"a drill", [](Json& plan) { tapOf(plan)["type"] = "drill"; }},
        {"a drill's work", [](Json& plan) { tapping(plan)["role"] = "drill"; }},
        {"nothing to tap", [](Json& plan) { tapping(plan).erase("thread"); }},
        {"one place less",
         [](Json& plan) {
             Json& operation = tapping(plan);
             operation["thread"]["places"].erase(0);
             operation["holes"] = operation["thread"]["places"].size();
         }},
        {"a place beside", [](Json& plan) { tapping(plan)["thread"]["places"][0][0] = 11; }},
        {"deeper", [](Json& plan) { tapping(plan)["z_floor_mm"] = -40; }},
        {"deeper thread", [](Json& plan) { tapping(plan)["thread"]["full_to_z_mm"] = -9.9; }},
        {"slower", [](Json& plan) { tapping(plan)["speed_rpm"] = 100; }},
        {"lower feed", [](Json& plan) { tapping(plan)["feed_mm_per_min"] = 100; }},
        {"higher feed", [](Json& plan) { tapping(plan)["feed_mm_per_min"] = 2000; }}};
    const Json plan = Json::parse(threaded().files.plan_json);
    EXPECT_FALSE(isCaught(plan));
    for (const auto& [name, weaken] : weakenings) {
        Json weak = plan;
        weaken(weak);
        EXPECT_TRUE(isCaught(weak)) << name;
    }
}

TEST(ThreadsProven, AMachineWithoutCoupledMotionMakesTheHolesAlone) {
    Machine machine = defaultMachine();
    machine.dialect = "grbl";
    const ProvenPlan proven =
        planWith(readHoleTable(kSource + "/samples/plate_holes.json"), shopWithTaps(), machine);
    EXPECT_TRUE(proven.mayRun());
    EXPECT_TRUE(tappingOf(proven.plan).empty());
    EXPECT_EQ(proven.plan.threads_missing, 10);
    EXPECT_FALSE(proven.plan.complete(kTol));
    const std::vector<Warning> warnings = warningsOf(proven.plan, "thread");
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_NE(warnings[0].text.find("has no motion coupled to the spindle"), std::string::npos);
    EXPECT_EQ(proven.plan.balance.planned_mm3, threaded().plan.balance.planned_mm3);
}

TEST(ThreadsProven, WithoutItsTapAThreadIsMissingAndSaidSo) {
    const ProvenPlan proven =
        planWith(readHoleTable(kSource + "/samples/plate_holes.json"), defaultToolLibrary());
    EXPECT_EQ(proven.plan.threads_missing, 10);
    EXPECT_FALSE(proven.plan.complete(kTol));
    const std::vector<Warning> warnings = warningsOf(proven.plan, "thread");
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_NE(warnings[0].text.find("the library has no tap"), std::string::npos) << warnings[0].text;
}

TEST(ThreadsProven, SomeHolesOfAGroupMayBeTapped) {
    // H5 to H10 are the six holes of 6.8 mm.
    const ProvenPlan proven =
        planWith(tableOf(R"({"ids": ["H5", "H8"], "make": "tap", "thread": "M8"})"), shopWithTaps());
    EXPECT_TRUE(proven.mayRun());
    const std::vector<const Operation*> tapping = tappingOf(proven.plan);
    ASSERT_EQ(tapping.size(), 1U);
    EXPECT_EQ(tapping[0]->holes, 2);
    EXPECT_TRUE(warningsOf(proven.plan, "hole-table").empty());
}

TEST(ThreadsProven, SomeHolesOfAGroupAreNotLeft) {
    const ProvenPlan proven = planWith(tableOf(R"({"ids": ["H5"], "make": "leave"})"), shopWithTaps());
    EXPECT_TRUE(proven.plan.balance.residual_by_reason.empty());
    const std::vector<Warning> warnings = warningsOf(proven.plan, "hole-table");
    ASSERT_EQ(warnings.size(), 1U);
    EXPECT_NE(warnings[0].text.find("chooses 1 of 6 equal holes"), std::string::npos) << warnings[0].text;
}

TEST(ThreadsProven, WhatTheTableLeavesIsNoGap) {
    const ProvenPlan proven =
        planWith(tableOf(R"({"diameter": {"min": 4.9, "max": 5.1}, "make": "leave"})"), shopWithTaps());
    EXPECT_TRUE(proven.mayRun());
    EXPECT_TRUE(proven.plan.complete(kTol));
    const auto& left = proven.plan.balance.residual_by_reason;
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left[0].reason.kind, Reason::AsAsked);
    EXPECT_NEAR(left[0].volume_mm3, 6 * 3.14159265 * 2.5 * 2.5 * 10, 1);
}

TEST(ThreadsProven, DrillsAloneLeaveTheRimOfAFlatHole) {
    const ProvenPlan proven =
        planWith(tableOf(R"({"diameter": {"min": 9.9, "max": 10.1}, "make": "drill"})"), shopWithTaps());
    EXPECT_TRUE(proven.mayRun());
    for (const PlannedSetup& setup : proven.plan.setups)
        for (const PlannedFeature& planned : setup.features) {
            if (planned.feature.feature_class != FeatureClass::HoleBlind) continue;
            for (const SequenceStep& step : planned.sequence.steps)
                EXPECT_EQ(step.role, Role::Drill);
            ASSERT_FALSE(planned.sequence.residual.empty());
            EXPECT_EQ(planned.sequence.residual[0].reason.kind, Reason::DrillPoint);
        }
}

TEST(ThreadsProven, EntriesThatChooseNothingAreSaid) {
    const ProvenPlan proven = planWith(
        tableOf(
            R"({"diameter": {"min": 3, "max": 4}, "make": "drill"}, {"ids": ["S9.F9"], "make": "leave"})"),
        shopWithTaps());
    const std::vector<Warning> warnings = warningsOf(proven.plan, "hole-table");
    ASSERT_EQ(warnings.size(), 2U);
    EXPECT_EQ(warnings[0].text, "holes.json#/holes/0 chooses no hole of the part");
}

TEST(ThreadsProven, AHoleOfTheNominalDiameterIsNoCore) {
    const ProvenPlan proven = planWith(
        tableOf(R"({"diameter": {"min": 8.4, "max": 8.6}, "make": "tap", "thread": "M8"})"), shopWithTaps());
    EXPECT_TRUE(tappingOf(proven.plan).empty());
    EXPECT_EQ(proven.plan.threads_missing, 4);
    EXPECT_NE(warningsOf(proven.plan, "thread").at(0).text.find("M8x1.25 is tapped into 6.647"),
              std::string::npos);
}

}  // namespace
}  // namespace stepmill
