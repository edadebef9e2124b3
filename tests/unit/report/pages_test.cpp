// Every page is well-formed, its links lead somewhere and it needs nothing but itself.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/feature/whole_feature.h"
#include "stepmill/part/part.h"
#include "stepmill/planar/region_text.h"
#include "stepmill/record/plan_json.h"
#include "stepmill/record/plan_record.h"
#include "stepmill/report/inspection.h"
#include "stepmill/report/part_views.h"
#include "stepmill/report/report.h"
#include "support/occt_solids.h"
#include "support/page_check.h"

namespace stepmill {
namespace {

using test::expectSoundPage;
using test::PageContent;
using test::readPage;

const char* const kHostile = "</title></main><script>alert(1)</script>\" ' & \x1b \xff";

Part samplePart(const std::string& name) {
    return readStep(std::string(STEPMILL_SOURCE_DIR) + "/step_parts/" + name + ".step").front();
}

const Plan& samplePlan() {
    static const Plan plan = [] {
        PlanRequest request;
        request.sequence.material = "aluminium";
        request.sequence.retract_mm = defaultMachine().safe_height_mm;
        return planPart(samplePart("shoulder_block"), request, defaultToolLibrary(), defaultMachine(),
                        Tolerances());
    }();
    return plan;
}

TEST(Pages, OfAPlanAreSound) {
    expectSoundPage(reportHtml(samplePlan(), Tolerances()), "report.html");
}

TEST(Pages, OfAnInspectionAreSound) {
    const Inspection inspection = inspectPart(samplePart("shoulder_block"), InspectRequest(), Tolerances());
    expectSoundPage(inspectionHtml(inspection), "inspect.html");
}

TEST(Pages, ViewsAreDrawingsOfTheirOwn) {
    for (const View& view : partViews(samplePlan().part, Eigen::Isometry3d::Identity()))
        expectSoundPage(view.svg, view.title);
}

TEST(Pages, LinkFeaturesAndOperationsToTheirPlaces) {
    const PageContent page = readPage(reportHtml(samplePlan(), Tolerances()));
    const std::set<std::string> ids(page.ids.begin(), page.ids.end());
    for (const PlannedSetup& setup : samplePlan().setups) {
        EXPECT_TRUE(ids.count("setup-" + setup.setup.id) != 0) << setup.setup.id;
        for (const PlannedFeature& planned : setup.features)
            EXPECT_TRUE(ids.count("feature-" + planned.feature.id) != 0) << planned.feature.id;
        for (const Operation& operation : setup.operations)
            EXPECT_TRUE(ids.count("operation-" + operation.id) != 0) << operation.id;
    }
}

/// The sample's two features, one below the other, as two bands of one.
Plan planInBands() {
    Plan plan = samplePlan();
    PlannedSetup& setup = plan.setups.front();
    int number = 0;
    for (PlannedFeature& planned : setup.features) {
        const std::string id = planned.feature.id;
        planned.feature.band = Band{"S1.F1", ++number, 2};
        planned.feature.id = bandId("S1.F1", number, 2);
        for (Operation& operation : setup.operations)
            if (operation.feature_id == id) operation.feature_id = planned.feature.id;
    }
    setup.features[1].feature.parents = {"S1.F1.1"};
    return plan;
}

TEST(Pages, HaveOneRowAndOneSectionForAFeatureOfSeveralBands) {
    const Plan plan = planInBands();
    const std::string page = reportHtml(plan, Tolerances());
    expectSoundPage(page, "report.html");
    const PageContent content = readPage(page);
    const std::set<std::string> ids(content.ids.begin(), content.ids.end());
    for (const char* id : {"feature-S1.F1", "feature-S1.F1.1", "feature-S1.F1.2"})
        EXPECT_EQ(ids.count(id), 1u) << id;
    EXPECT_NE(content.text.find("S1.F1 · step · 18.000 mm deep · 2 bands"), std::string::npos);
    EXPECT_NE(content.text.find("EM25 in 2 bands"), std::string::npos);
    EXPECT_NE(content.text.find("S1.F1.2 · step · from -8.000 to -18.000 mm"), std::string::npos);
    EXPECT_NE(summaryText(plan).find("\nS1.F1     step                        18.00 mm"), std::string::npos);
    EXPECT_EQ(summaryText(plan).find("S1.F1.1"), std::string::npos);
}

TEST(PlanJson, HasOneFeatureWithItsBandsThatAreReadBack) {
    const Plan plan = planInBands();
    const std::string text = planJson(plan);
    const auto json = nlohmann::json::parse(text);
    ASSERT_EQ(json.at("features").size(), 1u);
    EXPECT_EQ(json.at("setups")[0].at("features"), nlohmann::json{"S1.F1"});
    const auto& feature = json.at("features")[0];
    EXPECT_EQ(feature.at("floor_z_mm"), -18);
    EXPECT_EQ(feature.at("bands").size(), 2u);
    EXPECT_EQ(feature.at("levels"), 2);
    EXPECT_EQ(json.at("operations")[1].at("band"), 2);
    const PlanRecord record = planRecordFromText(text, Tolerances());
    for (const PlannedFeature& planned : plan.setups.front().features) {
        const Feature& read = record.features.at(planned.feature.id).feature;
        EXPECT_EQ(toText(read.target), toText(planned.feature.target));
        EXPECT_EQ(toText(read.obstruction), toText(planned.feature.obstruction));
        EXPECT_EQ(read.parents, planned.feature.parents);
        EXPECT_EQ(read.obstacles.size(), planned.feature.obstacles.size());
    }
}

TEST(PlanJson, HasWhatIsCutOfABandBeforeTheRestOfIt) {
    // 63 mm deep, where the mill of 25 gets to 61.5: two bands, of the lower one all but its last part first.
    PlanRequest request;
    request.sequence.material = "aluminium";
    const TopoDS_Shape slot = test::cut(test::box(0, 0, 0, 80, 60, 70), test::box(-1, 17, 7, 82, 26, 64));
    Part part = test::part(slot);
    part.name = part.file = "slot.step";
    part.sha256 = std::string(64, '0');
    const Plan plan = planPart(
        part, request, readToolLibrary(std::string(STEPMILL_SOURCE_DIR) + "/samples/shop_metric_tools.json"),
        defaultMachine(), Tolerances());
    const std::vector<PlannedFeature>& features = plan.setups.front().features;
    ASSERT_EQ(features.size(), 3U);
    EXPECT_EQ(features[1].feature.ground_of, std::vector<std::string>{features[2].feature.id});
    EXPECT_LT(features[2].feature.top_z_mm, features[0].feature.floor_z_mm);
    const PlanRecord record = planRecordFromText(planJson(plan), Tolerances());
    EXPECT_EQ(record.features.at(features[2].feature.id).feature.top_z_mm, features[2].feature.top_z_mm);
}

TEST(Pages, ShowHostileNamesAsText) {
    Plan plan = samplePlan();
    plan.part.name = plan.part.file = plan.material = plan.machine.name = kHostile;
    plan.warnings.push_back({"proof", kHostile, kHostile});
    plan.setups.front().clamping.text = kHostile;
    const std::string page = reportHtml(plan, Tolerances());
    expectSoundPage(page, "report.html");
    const PageContent content = readPage(page);
    EXPECT_NE(content.text.find("<script>alert(1)</script>\" ' &"), std::string::npos);
}

}  // namespace
}  // namespace stepmill
