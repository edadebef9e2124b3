#include <sys/stat.h>

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "report/page/drawing.h"
#include "report/page/words.h"
#include "stepmill/catalog/json_schema.h"
#include "stepmill/catalog/read_catalog.h"
#include "stepmill/core/error.h"
#include "stepmill/core/file.h"
#include "stepmill/record/plan_json.h"
#include "stepmill/report/part_views.h"
#include "stepmill/report/report.h"
#include "support/run_program.h"

namespace stepmill {
namespace {

namespace fs = std::filesystem;

/// The two-step block, the smallest part with two features, read and planned anew.
Plan planShoulder() {
    PlanRequest request;
    request.sequence.material = "aluminium";
    request.sequence.retract_mm = defaultMachine().safe_height_mm;
    const std::string file = std::string(STEPMILL_SOURCE_DIR) + "/step_parts/shoulder_block.step";
    return planPart(readStep(file).front(), request, defaultToolLibrary(), defaultMachine(), Tolerances());
}

const Plan& shoulderPlan() {
    static const Plan plan = planShoulder();
    return plan;
}

ProvenPlan provenShoulder() {
    return {shoulderPlan(), postedFiles(shoulderPlan()), {}};
}

TEST(PlanJson, ObeysItsSchema) {
    EXPECT_EQ(schemaErrors(SchemaName::Plan, planJson(shoulderPlan())), std::vector<std::string>());
}

TEST(PlanJson, TotalsAreTheSumsOfTheOperationsItLists) {
    const nlohmann::json plan = nlohmann::json::parse(planJson(shoulderPlan()));
    double sum_s = 0;
    for (const auto& operation : plan["operations"])
        sum_s += operation["time_s"].get<double>();
    const double changes_s = plan["totals"]["tool_change_s"];
    constexpr double kRoundingS = 1e-4;
    EXPECT_NEAR(plan["totals"]["time_s"].get<double>(), sum_s + changes_s, kRoundingS);
}

TEST(PlanJson, TheTransformTakesTheStockTopToZero) {
    const nlohmann::json plan = nlohmann::json::parse(planJson(shoulderPlan()));
    const auto transform = plan["setups"][0]["transform"];
    const auto stock_max = plan["stock"]["bbox_mm"][1];
    double z_mm = transform[11];
    for (int i = 0; i < 3; ++i)
        z_mm += transform[8 + i].get<double>() * stock_max[i].get<double>();
    EXPECT_NEAR(z_mm, 0, 1e-9);
}

TEST(PlanJson, IsTheSameOfTwoRuns) {
    EXPECT_EQ(planJson(planShoulder()), planJson(shoulderPlan()));
}

TEST(ReportHtml, ShowsEveryFeatureAndOperation) {
    const std::string html = reportHtml(shoulderPlan(), Tolerances());
    for (const PlannedFeature& planned : shoulderPlan().setups.front().features)
        EXPECT_NE(html.find(planned.feature.id), std::string::npos);
    for (const Operation& operation : shoulderPlan().setups.front().operations)
        EXPECT_NE(html.find(operation.id), std::string::npos);
}

TEST(ReportHtml, EscapesNamesFromTheFile) {
    Plan plan = shoulderPlan();
    plan.part.name = "<b>\"7\" & 8";
    const std::string html = reportHtml(plan, Tolerances());
    EXPECT_EQ(html.find("<b>\"7\""), std::string::npos);
    EXPECT_NE(html.find("&lt;b&gt;&quot;7&quot; &amp; 8"), std::string::npos);
}

TEST(SummaryText, NamesToolsTimesAndBooks) {
    const std::string text = summaryText(shoulderPlan());
    EXPECT_NE(text.find("S1.F1"), std::string::npos);
    EXPECT_NE(text.find(shoulderPlan().setups.front().operations.front().tool_id), std::string::npos);
    EXPECT_NE(text.find("books:"), std::string::npos);
}

TEST(SummaryText, WhatALaterSetupTakesDoesNotStay) {
    Plan plan = shoulderPlan();
    ToolSequence& sequence = plan.setups.front().features.front().sequence;
    sequence.steps.clear();
    Residual& left = sequence.residual.emplace_back();
    left.volume_mm3 = 7000;
    left.stays_mm3 = 1000;
    EXPECT_NE(summaryText(plan).find("none fits                           1.000 cm3"), std::string::npos);
    left.stays_mm3 = 0;
    left.taken_by = "S3";
    EXPECT_NE(summaryText(plan).find("left to S3                          0.000 cm3"), std::string::npos);
}

TEST(WritePlan, LeavesAllFilesAndNothingElse) {
    const test::TemporaryFolder folder;
    JobFolder job(fs::path(folder.path()) / "a" / "job");
    writePlan(provenShoulder(), {"a page", "", ""}, ReportOptions(), job, Tolerances());
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder.path()))
        if (entry.is_regular_file()) names.insert(entry.path().filename().string());
    EXPECT_EQ(names, (std::set<std::string>{"plan.json", "report.html", "sheets.html", "S1.ngc",
                                            "manifest.json", ".job.stepmill-lock"}));
}

TEST(WritePlan, WithoutAProofThereIsNoProgramAndNoneOfAnEarlierPlan) {
    const test::TemporaryFolder folder;
    JobFolder job(fs::path(folder.path()) / "job");
    writePlan(provenShoulder(), {"a page", "", ""}, ReportOptions(), job, Tolerances());
    ProvenPlan failed = provenShoulder();
    failed.verification.failures.push_back({"S1.ngc", 1, "S1.O1", "cuts too deep"});
    writePlan(failed, {"a page", "", ""}, ReportOptions(), job, Tolerances());
    EXPECT_TRUE(fs::exists(job.path() / "plan.json"));
    EXPECT_FALSE(fs::exists(job.path() / "S1.ngc"));
}

TEST(WritePlan, ASetupThatCutsNothingHasNoProgram) {
    const test::TemporaryFolder folder;
    JobFolder job(fs::path(folder.path()) / "job");
    ProvenPlan idle = provenShoulder();
    PlannedSetup& second = idle.plan.setups.emplace_back(idle.plan.setups.front());
    second.setup.id = "S2";
    second.features.clear();
    second.operations.clear();
    idle.files = postedFiles(idle.plan);
    writePlan(idle, {"a page", "", ""}, ReportOptions(), job, Tolerances());
    EXPECT_TRUE(fs::exists(job.path() / "S1.ngc"));
    EXPECT_FALSE(fs::exists(job.path() / "S2.ngc"));
    EXPECT_NE(summaryText(idle.plan).find("nothing can be cut from here"), std::string::npos);
}

TEST(WritePlan, LeavesNothingBehindWhereItCannotWrite) {
    const test::TemporaryFolder folder;
    writeFile(fs::path(folder.path()) / "file", "in the way");
    try {
        const JobFolder job(fs::path(folder.path()) / "file" / "job");
        FAIL() << "a folder below a file cannot be made";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::OutputUnwritable);
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
}

TEST(PartViews, DrawsFourViewsWithVisibleAndHiddenEdges) {
    const Plan& plan = shoulderPlan();
    const std::vector<View> views = partViews(plan.part, plan.setups.front().setup.part_to_setup);
    ASSERT_EQ(views.size(), 4u);
    for (const View& view : views)
        EXPECT_NE(view.svg.find("class=\"visible\""), std::string::npos) << view.title;
    EXPECT_NE(views.back().svg.find("class=\"hidden\""), std::string::npos);
}

TEST(Drawing, TurnsYUpIntoSvgsYDown) {
    Box2 frame;
    frame.extend(Vec2(0, 0));
    frame.extend(Vec2(10, 20));
    const std::string text = report::Drawing(frame, "a frame").element().markup();
    EXPECT_NE(text.find("viewBox=\"-0.600 -20.600 11.200 21.200\""), std::string::npos) << text;
    EXPECT_NE(text.find("scale(0.001,-0.001)"), std::string::npos) << text;
}

TEST(ClockTime, ReadsLikeAClock) {
    using report::clockTime;
    EXPECT_EQ(clockTime(7.26), "7.3 s");
    EXPECT_EQ(clockTime(59.97), "1:00");
    EXPECT_EQ(clockTime(247), "4:07");
    EXPECT_EQ(clockTime(3729), "1:02:09");
}

}  // namespace
}  // namespace stepmill
