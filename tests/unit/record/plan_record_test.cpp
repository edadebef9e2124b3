// What is read of a plan.json, and what is refused.

#include "stepmill/record/plan_record.h"

#include <gtest/gtest.h>

#include <functional>

#include <nlohmann/json.hpp>

#include "stepmill/core/error.h"
#include "stepmill/core/file.h"

namespace stepmill {
namespace {

using Json = nlohmann::ordered_json;

/// The seeds of the fuzz target are plans as small as can be: "disc" of one band, "bands" of two and a child
/// of the first, "assigned" with a setup in which nothing is cut and one that leaves stock.
Json seed(const std::string& name) {
    return Json::parse(
        readFile(std::string(STEPMILL_SOURCE_DIR) + "/tests/fuzz/corpus/plan_record_fuzz/" + name));
}

PlanRecord recordOf(const Json& plan) {
    return planRecordFromText(plan.dump(), Tolerances());
}

void expectRefused(const Json& plan, const std::string& place, const std::string& words) {
    try {
        recordOf(plan);
        ADD_FAILURE() << "was read: " << words;
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::InvalidCatalog);
        EXPECT_EQ(error.subject(), "plan.json" + place);
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

TEST(PlanRecord, HasAPrismaticFeatureAsOneBandOfItsName) {
    const PlanRecord record = recordOf(seed("disc"));
    ASSERT_EQ(record.features.size(), 1u);
    const Feature& feature = record.features.at("S1.F1").feature;
    EXPECT_FALSE(feature.band);
    EXPECT_NEAR(area(feature.target), 314.159265, 1e-6);
    EXPECT_EQ(feature.obstacles.size(), 1u);
    EXPECT_EQ(record.operations.at("S1.O1").feature_id, "S1.F1");
    EXPECT_NEAR(area(record.setups.front().fixtures.front().section), 19 * 40, 1e-9);
}

TEST(PlanRecord, HasEveryBandWithItsNameAndParents) {
    const PlanRecord record = recordOf(seed("bands"));
    EXPECT_EQ(record.setups.front().feature_ids, (std::vector<std::string>{"S1.F1.1", "S1.F1.2", "S1.F2"}));
    const Feature& lower = record.features.at("S1.F1.2").feature;
    ASSERT_TRUE(lower.band);
    EXPECT_EQ(lower.band->of, "S1.F1");
    EXPECT_EQ(lower.band->number, 2);
    EXPECT_EQ(lower.band->count, 2);
    EXPECT_EQ(lower.parents, std::vector<std::string>{"S1.F1.1"});
    EXPECT_EQ(record.features.at("S1.F2").feature.parents, std::vector<std::string>{"S1.F1.1"});
    EXPECT_EQ(record.operations.at("S1.O1").feature_id, "S1.F1.2");
}

TEST(PlanRecord, GivesALaterPlanItsSetupsAndWhatEachLeaves) {
    const PlanRecord record = recordOf(seed("assigned"));
    const auto earlier = earlierAssignment(record);
    ASSERT_TRUE(earlier);
    const Assignment& assignment = earlier->assignment;
    EXPECT_EQ(assignment.seen.size(), 1u);
    ASSERT_EQ(assignment.axes.size(), 2u);
    ASSERT_EQ(assignment.reserves.size(), 2u);
    EXPECT_TRUE(assignment.reserves[0].prisms.empty());
    ASSERT_EQ(assignment.reserves[1].prisms.size(), 1u);
    EXPECT_EQ(assignment.reserves[1].prisms[0].bottom_z_mm, -1);
    ASSERT_EQ(assignment.choices.size(), 2u);
    EXPECT_EQ(assignment.choices[1].verdict, SetupVerdict::CannotTakeLess);
    EXPECT_EQ(assignment.choices[1].axes[1], -Vec3::UnitX());
    ASSERT_EQ(assignment.tried.size(), 1u);
    EXPECT_EQ(assignment.tried[0].verdict, Verdict::Taken);
    EXPECT_EQ(earlier->left_mm3, record.books.leftMm3());
    EXPECT_EQ(earlierSetups(record).front().leaning_mm3, 12.5);
}

TEST(PlanRecord, GivesALaterPlanNoSetupsWhereItTellsNoneOrOthersOrHadNoTime) {
    EXPECT_FALSE(earlierAssignment(recordOf(seed("disc"))));
    Json hasty = seed("assigned");
    hasty["setup_choices"][1]["verdict"] = "no time";
    EXPECT_FALSE(earlierAssignment(recordOf(hasty)));
    Json plan = seed("assigned");
    plan["setup_axes"]["taken"] = {{1.0, 0.0, 0.0}};
    EXPECT_FALSE(earlierAssignment(recordOf(plan)));
}

TEST(PlanRecord, RefusesAnAxisThatIsNoDirection) {
    Json plan = seed("assigned");
    plan["setup_axes"]["taken"][0] = {0.0, 0.0, 0.0};
    expectRefused(plan, "#/setup_axes/taken/0", "expected a direction of length 1");
}

TEST(PlanRecord, RefusesAPlanOfAnotherFormatWithAdvice) {
    Json plan = seed("disc");
    plan["format"] = 1;
    plan["features"] = Json::array({Json::object()});
    expectRefused(plan, "#/format", "expected 2, found 1");
    expectRefused(plan, "#/format", "plan the part again");
}

TEST(PlanRecord, RefusesNumbersOfEntriesThatAreNot) {
    Json plan = seed("disc");
    plan["features"][0]["bands"][0]["target"] = 4;
    expectRefused(plan, "#/features/0/bands/0/target", "one of 4 regions, found 4");
    plan = seed("disc");
    plan["features"][0]["bands"][0]["obstacles"] = {0, 1};
    expectRefused(plan, "#/features/0/bands/0/obstacles/1", "one of 1 obstacles, found 1");
    plan = seed("disc");
    plan["regions"][1] = {7};
    expectRefused(plan, "#/regions/1", "one of 3 loops, found 7");
    plan = seed("disc");
    plan["operations"][0]["band"] = 2;
    expectRefused(plan, "#/operations/0/feature", "band 2 of 'S1.F1'");
    plan = seed("bands");
    plan["features"][1]["bands"][0]["parents"][0]["band"] = 3;
    expectRefused(plan, "#/features/1/bands/0/parents", "band 3 of 'S1.F1'");
}

TEST(PlanRecord, RefusesBandsThatDoNotMakeUpTheirFeature) {
    Json plan = seed("bands");
    plan["features"][0]["bands"][1]["top_z_mm"] = -2.5;
    expectRefused(plan, "#/features/0/bands/1/top_z_mm", "the floor of the band above");
    plan = seed("bands");
    plan["features"][0]["floor_z_mm"] = -6;
    expectRefused(plan, "#/features/0/floor_z_mm", "what its bands say");
    plan = seed("bands");
    plan["features"][0]["volume_mm3"] = 1571.8;
    expectRefused(plan, "#/features/0/volume_mm3", "what its bands say");
}

TEST(PlanRecord, KeepsTheNamesOfBandsWhereCommonGroundTookOthers) {
    Json plan = seed("bands");
    Json& feature = plan["features"][0];
    feature["levels"] = 4;
    feature["bands"][1]["band"] = 3;
    feature["bands"][1]["top_z_mm"] = -3;
    plan["operations"][0]["band"] = 3;
    const PlanRecord record = recordOf(plan);
    EXPECT_EQ(record.setups.front().feature_ids, (std::vector<std::string>{"S1.F1.1", "S1.F1.3", "S1.F2"}));
    EXPECT_EQ(record.features.at("S1.F1.3").feature.band->count, 4);
    EXPECT_EQ(record.operations.at("S1.O1").feature_id, "S1.F1.3");
}

TEST(PlanRecord, RefusesBandsThatWaitForThemselves) {
    Json plan = seed("bands");
    plan["features"][0]["bands"][0]["parents"] = {{{"feature", "S1.F1"}, {"band", 2}}};
    expectRefused(plan, "#/features", "waits for itself");
    plan = seed("bands");
    plan["features"][0]["bands"][1]["band"] = 1;
    expectRefused(plan, "#/features/0/bands/1/band", "above that of the band above");
}

TEST(PlanRecord, RefusesAColumnThatMissesAnEntry) {
    Json plan = seed("disc");
    plan["features"][0]["bands"][0]["dag"]["edges"]["time_s"] = Json::array();
    expectRefused(plan, "#/features/0/bands/0/dag/edges/time_s", "expected 1 entries");
}

TEST(PlanRecord, RefusesALargeRegionThatIsNamedTooOften) {
    Json plan = seed("disc");
    // A comb of 20000 segments as obstacle, a thousand times.
    Json comb = Json::parse("[[0,0],[0,-1000000],[10000000,0],[0,1000000]]");
    for (int tooth = 0; tooth < 5000; ++tooth)
        for (const Json& segment : Json::parse("[[-1000,0],[0,5000000],[-1000,0],[0,-5000000]]"))
            comb.push_back(segment);
    plan["loops"].push_back(comb);
    plan["regions"].push_back({3});
    plan["obstacles"][0]["section"] = 4;
    plan["features"][0]["bands"][0]["obstacles"] = std::vector<int>(1000, 0);
    expectRefused(plan, "#/features/0/bands/0/obstacles/747", "no more than 15000000 segments");
}

}  // namespace
}  // namespace stepmill
