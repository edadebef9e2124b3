#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stepmill/catalog/read_catalog.h"
#include "stepmill/record/plan_json.h"
#include "stepmill/report/report.h"
#include "support/tolerances.h"

namespace stepmill {
namespace {

using test::kTol;

/// The pocket beside bosses, where the 0.2 in cutter helps the 0.5 in one.
const Plan& bossedPlan() {
    static const Plan plan = [] {
        const std::string source = STEPMILL_SOURCE_DIR;
        PlanRequest request;
        request.sequence.material = "aluminium";
        request.sequence.surrogates = SurrogateRule::Single;
        // The paper's holders touch.
        Machine machine = defaultMachine();
        machine.holder_clearance_mm = 0;
        return planPart(readStep(source + "/step_parts/bossed_pocket.step").front(), request,
                        readToolLibrary(source + "/samples/dsouza2006_tools.json"), machine, kTol);
    }();
    return plan;
}

TEST(SurrogateReport, PlanJsonTellsLumpsEdgesAndOperations) {
    const auto plan = nlohmann::json::parse(planJson(bossedPlan()));
    const auto& pocket = plan.at("features").back().at("bands").back();
    EXPECT_EQ(pocket.at("dag").at("path"), (nlohmann::json{"t8", "t2", "t1"}));
    const auto& tools = pocket.at("tools");
    ASSERT_EQ(tools.at("tool").front(), "t8");
    int lumps = 0;
    double lumps_mm2 = 0;
    for (const auto& lump : pocket.at("blocked_lumps")) {
        if (lump.at("tool") != "t8") continue;
        ++lumps;
        EXPECT_EQ(lump.at("surrogates"), (nlohmann::json{"t2", "t1"}));
        EXPECT_FALSE(lump.at("reason").get<std::string>().empty());
        lumps_mm2 += lump.at("area_mm2").get<double>();
    }
    EXPECT_EQ(lumps, 2) << "one by each boss";
    const double kept_off_mm2 = tools.at("coverable_area_mm2").front().get<double>() -
                                tools.at("collision_free_area_mm2").front().get<double>();
    EXPECT_NEAR(lumps_mm2, kept_off_mm2, 0.01);
    int helped = 0;
    for (const auto& work : pocket.at("dag").at("surrogates")) {
        if (work.at("from") != "source" || work.at("to") != "t8") continue;
        ++helped;
        EXPECT_EQ(work.at("tool"), "t2");
        EXPECT_NEAR(work.at("area_mm2").get<double>(), lumps_mm2, 1e-6);
    }
    EXPECT_EQ(helped, 1);
    int surrogates = 0;
    for (const auto& operation : plan.at("operations"))
        surrogates += operation.at("role") == "surrogate" && operation.at("tool") == "t2" ? 1 : 0;
    EXPECT_EQ(surrogates, 2);
}

TEST(SurrogateReport, SummaryAndPagesNameThem) {
    EXPECT_NE(summaryText(bossedPlan()).find("t8 (+ t2) > t2 > t1"), std::string::npos);
    const std::string html = reportHtml(bossedPlan(), kTol);
    EXPECT_NE(html.find("surrogates that reach it"), std::string::npos);
    EXPECT_NE(html.find("t8 (+ t2) &gt; t2 &gt; t1"), std::string::npos);
}

}  // namespace
}  // namespace stepmill
