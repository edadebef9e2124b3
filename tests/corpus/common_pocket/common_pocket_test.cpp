// The whole plan of the pocket that other systems' figures are known for, with its three cutters.

#include <gtest/gtest.h>

#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "support/expected_outcomes.h"
#include "support/planned_parts.h"
#include "support/text_file.h"

namespace stepmill::test {
namespace {

using Json = nlohmann::json;

/// FreeCAD 0.20's Pocket with the cutters that clear the pocket alone.
const std::map<std::string, double> kElsewhere_s{{"D12", 103.0}, {"D6", 257.3}};
/// With 20 mm, which leave 164 mm2 of the floor.
constexpr double kElsewhereLargest_s = 46.8;
constexpr double kShorter = 0.1;
/// Of theirs no 3 degree ramp makes more (tests/unit/toolpath/common_pocket_test.cpp).
constexpr double kLargestShorter = 0.025;

Json planOfThePocket() {
    const std::string source = STEPMILL_SOURCE_DIR;
    const PlannedPart planned = plannedPart(source + "/step_parts/rounded_pocket.step",
                                            {"--tools", source + "/samples/common_pocket_tools.json",
                                             "--machine", source + "/samples/common_pocket_machine.json",
                                             // As other systems take it: the blank is exact.
                                             "--stock-tolerance", "0"});
    EXPECT_EQ(planned.run.exit_code, 0) << planned.run.err;
    return Json::parse(slurp(planned.folder / "plan.json"));
}

TEST(CommonPocketPlan, HasEveryCutterShorterAndTheirSequenceBelowThoseThatFinish) {
    const Json plan = planOfThePocket();
    ASSERT_EQ(plan.at("features").size(), 1U);
    const Json& feature = plan.at("features").front();
    const double whole_s = feature.at("time_s");
    std::map<std::string, double> alone_s;
    ASSERT_EQ(feature.at("bands").size(), 1U);
    const Json& pocket = feature.at("bands").front();
    const Json& edges = pocket.at("dag").at("edges");
    for (std::size_t i = 0; i < edges.at("from").size(); ++i)
        if (edges.at("from")[i] == "source") alone_s[edges.at("to")[i]] = edges.at("time_s")[i];
    ASSERT_EQ(alone_s.size(), 3U);
    EXPECT_LE(alone_s.at("D20"), (1 - kLargestShorter) * kElsewhereLargest_s);
    for (const auto& [tool, elsewhere_s] : kElsewhere_s) {
        EXPECT_LE(alone_s.at(tool), (1 - kShorter) * elsewhere_s) << tool;
        EXPECT_LT(whole_s, alone_s.at(tool)) << tool;
    }
    EXPECT_TRUE(pocket.at("residual").empty());
}

TEST(CommonPocketPlan, TellsOfEveryPatternWeighed) {
    const Json plan = planOfThePocket();
    for (const Json& operation : plan.at("operations")) {
        EXPECT_GT(operation.at("even_length_mm"), 0);
        ASSERT_FALSE(operation.at("regions").empty());
        for (const Json& region : operation.at("regions"))
            for (const Json& other : region)
                EXPECT_LE(region.front().at("time_s").get<double>(),
                          other.at("time_s").get<double>() * (1 + 1e-5));
    }
}

/// Below 5 % of the time of every operation that has the pocket to itself.
TEST(CommonPocketPlan, IsHardlyEverInAir) {
    const Json plan = planOfThePocket();
    for (const Json& operation : plan.at("operations")) {
        if (operation.at("role") != "rough") continue;
        const double air_s = operation.at("air_length_mm").get<double>() / 5000 * 60 +
                             operation.at("feed_air_length_mm").get<double>() / 300 * 60;
        EXPECT_LT(air_s, 0.05 * operation.at("time_s").get<double>());
    }
}

/// Of all feed motion in closed pockets, rest material in their corners included, less than that is in air:
/// rapids come down beside the walls, and the tool is fed from there. Small tools in corners glide down, at
/// several times the cutting feed, where a rapid has no room.
constexpr double kMostAirShare = 0.11;

class ClosedPockets : public testing::TestWithParam<ExpectedOutcome> {};

TEST_P(ClosedPockets, AreCutWithHardlyAnyFeedInAir) {
    const PlannedPart planned = plannedPart(GetParam().path);
    ASSERT_LE(planned.run.exit_code, 1) << planned.run.err;
    const Json plan = Json::parse(slurp(planned.folder / "plan.json"));
    std::set<std::string> pockets;
    for (const Json& feature : plan.at("features"))
        if (feature.at("class") == "closed pocket") pockets.insert(feature.at("id"));
    double cut_mm = 0;
    double air_mm = 0;
    for (const Json& operation : plan.at("operations")) {
        if (pockets.count(operation.at("feature")) == 0) continue;
        cut_mm += operation.at("cut_length_mm").get<double>();
        air_mm += operation.at("feed_air_length_mm").get<double>();
    }
    EXPECT_LE(air_mm, kMostAirShare * cut_mm);
}

INSTANTIATE_TEST_SUITE_P(SampleParts, ClosedPockets, testing::ValuesIn(expectedOf("step_parts")),
                         [](const auto& row) { return testName(row.param); });

}  // namespace
}  // namespace stepmill::test
