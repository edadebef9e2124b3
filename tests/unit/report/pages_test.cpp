// Every page is well-formed, its links lead somewhere and it needs nothing but itself.

#include <gtest/gtest.h>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/part/part.h"
#include "stepmill/report/inspection.h"
#include "stepmill/report/part_views.h"
#include "stepmill/report/report.h"
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
