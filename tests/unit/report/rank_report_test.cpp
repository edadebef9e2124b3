#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "stepmill/catalog/json_schema.h"
#include "stepmill/report/rank.h"

namespace stepmill {
namespace {

using Json = nlohmann::json;

RankReport tableReport() {
    RankReport report;
    report.file = "cutters.csv";
    report.ranking = rankTools({{"", 6, 100, 10}, {"", 12, 90, 60}, {"", 20, 0, 90}}, 30);
    return report;
}

/// One feature with two ranges and a purchase, one without either.
RankReport partReport() {
    RankReport report;
    report.is_part = true;
    report.file = "plate.step";
    report.material = "steel";
    report.ranking = rankTools({{"EM6", 6, 100, 10, 80}, {"EM12", 12, 90, 60, 90}}, 5);
    Sensitivity sensitivity{Parameter::ToolChange, 5, "s", Objective::Time, "EUR", {}};
    const double infinite = std::numeric_limits<double>::infinity();
    sensitivity.features.push_back(
        {"S1.F1", {{0, 50, {50, 2, {"EM12", "EM6"}}}, {50, infinite, {100, 1, {"EM6"}}}}, {}});
    sensitivity.features.push_back({"S1.F2", {{0, infinite, {}}}, {}});
    sensitivity.features.push_back({"S1.F3", {}, "a gouge"});
    report.sensitivity = sensitivity;
    PurchaseAdvice advice;
    advice.feature_id = "S1.F1";
    advice.time_s = 100;
    advice.trials = 2;
    Purchase purchase;
    purchase.tool.id = "new end mill 9";
    purchase.tool.diameter_mm = 9;
    purchase.why = "of the usual series";
    purchase.tools = {"EM12", "new end mill 9"};
    purchase.saved_s = 30;
    advice.best = purchase;
    PurchaseAdvice failed;
    failed.feature_id = "S1.F3";
    report.purchases = {{advice, {}},
                        {advice, {}},
                        {PurchaseAdvice{"S1.F2", 1, 0, 0, 3, std::nullopt}, {}},
                        {failed, "a gouge"}};
    return report;
}

TEST(RankReport, JsonOfATableHasRowsAndBothSequences) {
    const Json json = Json::parse(rankJson(tableReport()));
    EXPECT_EQ(json.at("source").at("kind"), "table");
    ASSERT_EQ(json.at("rows").size(), 3u);
    const Json& wide = json.at("rows").at(1);
    EXPECT_EQ(wide.at("rank"), 1);
    EXPECT_TRUE(wide.at("tool").is_null());
    EXPECT_TRUE(wide.at("clear_volume_cm3").is_null());
    EXPECT_DOUBLE_EQ(wide.at("time_min"), 1.5);
    EXPECT_DOUBLE_EQ(wide.at("rdvc_min"), 2.5);
    EXPECT_DOUBLE_EQ(wide.at("rdvc_with_tool_changes_min"), 3);
    EXPECT_TRUE(json.at("rows").at(2).at("rank").is_null());
    EXPECT_TRUE(json.at("rows").at(2).at("dvcd_min").is_null());
    EXPECT_EQ(json.at("greedy").at("tools"), (std::vector<double>{12, 6}));
    EXPECT_DOUBLE_EQ(json.at("shortest_path").at("total_min"), 3);
    EXPECT_TRUE(json.at("sensitivity").is_null());
    EXPECT_TRUE(json.at("purchases").is_null());
}

TEST(RankReport, JsonOfAPartNamesToolsRangesAndPurchases) {
    const Json json = Json::parse(rankJson(partReport()));
    EXPECT_EQ(json.at("shortest_path").at("tool_ids"), (std::vector<std::string>{"EM12", "EM6"}));
    const Json& ranges = json.at("sensitivity").at("features").at(0).at("ranges");
    EXPECT_EQ(ranges.at(0).at("to"), 50);
    EXPECT_TRUE(ranges.at(1).at("to").is_null());
    EXPECT_EQ(json.at("purchases").at(0).at("best").at("tool"), "new end mill 9");
    EXPECT_TRUE(json.at("purchases").at(2).at("best").is_null());
}

TEST(RankReport, TextHasTheTableBreakEvensAndPurchases) {
    const std::string text = rankText(partReport());
    for (const char* words :
         {"plate.step, all features, steel", "EM12 > EM6", "up to 50", "from 50", "none fits",
          "new end mill 9 (of the usual series): saves 0.50 min", "nothing helps (3 tried)",
          "new end mill 9: 1.00 min over 2 features", "S1.F3    planning failed: a gouge"})
        EXPECT_NE(text.find(words), std::string::npos) << words << " not in\n" << text;
}

TEST(RankReport, TextOfATableThatReachesNothingSaysSo) {
    RankReport report;
    report.file = "cutters.csv";
    report.ranking = rankTools({{"", 6, 0, 10}}, 0);
    EXPECT_NE(rankText(report).find("nothing is reached"), std::string::npos);
    EXPECT_DOUBLE_EQ(Json::parse(rankJson(report)).at("greedy").at("total_min"), 0);
}

}  // namespace
}  // namespace stepmill
