// `stepmill rank`: tables, parts, and how bad input ends.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "support/plan_bands.h"
#include "support/run_program.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const std::string kSource = STEPMILL_SOURCE_DIR;
const std::string kPaperTable = kSource + "/samples/lim2000_fig8.csv";
const std::string kPart = kSource + "/step_parts/bossed_pocket.step";

class RankCommand : public testing::Test {
  protected:
    ProgramRun rank(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {stepmillBinary(), "rank"});
        return runProgram(arguments);
    }

    Json rankJson(std::vector<std::string> arguments) const {
        arguments.emplace_back("--json");
        const ProgramRun run = rank(arguments);
        EXPECT_EQ(run.exit_code, 0) << run.err;
        return Json::parse(run.out);
    }

    std::string write(const std::string& name, const std::string& text) const {
        const fs::path path = fs::path(folder_.path()) / name;
        std::ofstream(path) << text;
        return path.string();
    }

    /// Exit code 2 and one line on stderr that holds every word.
    void expectRefused(const std::vector<std::string>& arguments,
                       const std::vector<std::string>& words) const {
        const ProgramRun run = rank(arguments);
        EXPECT_EQ(run.exit_code, 2) << run.err;
        EXPECT_EQ(run.out, "");
        for (const std::string& word : words)
            EXPECT_NE(run.err.find(word), std::string::npos) << "no '" << word << "' in: " << run.err;
    }

    TemporaryFolder folder_;
};

Json rowOfRank(const Json& ranking, int rank) {
    for (const Json& row : ranking.at("rows"))
        if (row.at("rank") == rank) return row;
    return {};
}

TEST_F(RankCommand, GivesThePapersRanks) {
    const Json ranking = rankJson({kPaperTable});
    EXPECT_EQ(ranking.at("format"), 1);
    EXPECT_EQ(rowOfRank(ranking, 0).at("diameter_mm"), 12);
    EXPECT_NEAR(rowOfRank(ranking, 0).at("rdvc_min").get<double>(), 6.199, 5e-4);
    EXPECT_EQ(rowOfRank(ranking, 1).at("diameter_mm"), 28);
    EXPECT_NEAR(rowOfRank(ranking, 1).at("rdvc_min").get<double>(), 1.475, 5e-4);
    const std::string text = rank({kPaperTable}).out;
    EXPECT_NE(text.find("6.199"), std::string::npos);
    EXPECT_NE(text.find("shortest path"), std::string::npos);
}

TEST_F(RankCommand, ShortestPathIsNeverWorseWhateverTheToolChangeTime) {
    double last_min = 0;
    for (const char* change_s : {"0", "1", "10", "60", "600", "100000"}) {
        const Json ranking = rankJson({kPaperTable, "--tool-change", change_s});
        const double shortest_min = ranking.at("shortest_path").at("total_min");
        EXPECT_LE(shortest_min, ranking.at("greedy").at("total_min").get<double>()) << change_s;
        EXPECT_GE(shortest_min, last_min) << change_s;
        last_min = shortest_min;
    }
    EXPECT_NEAR(last_min, 6.199, 5e-4);  // one tool, whose change does not count
}

TEST_F(RankCommand, ABrokenTableNamesFileLineAndExpectation) {
    const std::string header = "diameter_mm,volume_cm3,mrr_cm3_per_min\n";
    expectRefused({write("a.csv", "d,v,m\n1,2,3\n")},
                  {"a.csv, line 1", "diameter_mm,volume_cm3,mrr_cm3_per_min"});
    expectRefused({write("b.csv", header + "10,5,3\n12,x,3\n")}, {"b.csv, line 3", "volume_cm3", "'x'"});
    expectRefused({write("c.csv", header + "10,5,0\n")}, {"c.csv, line 2", "above 0"});
    expectRefused({write("d.csv", header)}, {"d.csv, line 2"});
    expectRefused({write("e.csv", "")}, {"e.csv, line 1"});
    expectRefused({"no_such_table.csv"}, {"no_such_table.csv"});
}

TEST_F(RankCommand, RefusesWhatATableCannotAnswer) {
    expectRefused({kPaperTable, "--buy"}, {"--buy", "part"});
    expectRefused({kPaperTable, "--feature", "S1.F1"}, {"--feature", "part"});
    for (const char* seconds : {"-1", "nan", "inf", "soon"})
        expectRefused({kPaperTable, "--tool-change", seconds}, {"--tool-change"});
    expectRefused({kPaperTable, "--json", "--csv"}, {"--csv"});
    expectRefused({kPart, "--sensitivity", "weather"}, {"--sensitivity"});
    expectRefused({kPart, "--feature", "S9.F9"}, {"S9.F9", "S1.F1"});
}

TEST_F(RankCommand, APartsTableFedBackGivesTheSameRanking) {
    const ProgramRun csv = rank({kPart, "--csv"});
    ASSERT_EQ(csv.exit_code, 0) << csv.err;
    const Json part = rankJson({kPart, "--tool-change", "7"});
    const Json table = rankJson({write("part.csv", csv.out), "--tool-change", "7"});
    EXPECT_EQ(part.at("greedy").at("total_min"), table.at("greedy").at("total_min"));
    EXPECT_EQ(part.at("shortest_path").at("tools"), table.at("shortest_path").at("tools"));
    EXPECT_EQ(part.at("rows").size(), table.at("rows").size());
    EXPECT_EQ(part.at("shortest_path").at("tool_ids").size(), part.at("shortest_path").at("tools").size());
}

TEST_F(RankCommand, VolumesOfFeaturesAddUpToThePart) {
    std::map<std::string, double> sum_cm3;
    for (const char* id : {"S1.F1", "S1.F2"}) {
        const Json feature = rankJson({kPart, "--feature", id});
        EXPECT_EQ(feature.at("source").at("feature"), id);
        for (const Json& row : feature.at("rows"))
            sum_cm3[row.at("tool")] += row.at("volume_cm3").get<double>();
    }
    const Json part = rankJson({kPart});
    EXPECT_EQ(part.at("rows").size(), sum_cm3.size());
    for (const Json& row : part.at("rows"))
        EXPECT_NEAR(row.at("volume_cm3").get<double>(), sum_cm3.at(row.at("tool")), 1e-6) << row;
}

TEST_F(RankCommand, TheMachinesValueLiesInARangeThatCostsWhatThePlanSays) {
    const fs::path out = fs::path(folder_.path()) / "plan";
    const ProgramRun plan = runProgram({stepmillBinary(), "plan", kPart, "-o", out.string(), "--json"});
    std::map<std::string, double> time_s;
    const Json planned = Json::parse(plan.out);
    // The sample machine gives an acceleration, so tools are chosen by times with it.
    for (const BandOfPlan& one : bandsOf(planned))
        time_s[one.id] = one.band.at("motion_time_s");
    const Json sensitivity = rankJson({kPart, "--sensitivity", "tool-change"}).at("sensitivity");
    const double now_s = sensitivity.at("now");
    ASSERT_EQ(sensitivity.at("features").size(), time_s.size());
    for (const Json& feature : sensitivity.at("features")) {
        for (const Json& range : feature.at("ranges")) {
            const bool holds =
                range.at("from") <= now_s && (range.at("to").is_null() || now_s < range.at("to"));
            if (!holds) continue;
            const double here_s =
                range.at("fixed").get<double>() + now_s * range.at("per_unit").get<double>();
            // The plan's steps take the quickest patterns, and tools that its features share.
            const double planned_s = time_s.at(feature.at("feature"));
            EXPECT_NEAR(here_s, planned_s, 0.15 * planned_s) << feature;
        }
        EXPECT_TRUE(feature.at("ranges").back().at("to").is_null());
    }
}

/// The tools of each feature in their order, each visit once; nothing where sharing changed some. Not
/// those below material that stays, which `rank` takes for cut.
std::map<std::string, std::vector<std::string>> unsharedTools(const Json& plan) {
    std::map<std::string, std::vector<std::string>> tools;
    if (plan.at("tool_sharing").at("features_changed") != 0) return tools;
    // What common ground was taken out of is another feature than rank sees.
    std::set<std::string> without_ground;
    for (const Json& feature : plan.at("features"))
        if (feature.contains("ground_of"))
            for (const Json& level : feature.at("ground_of"))
                without_ground.insert(level.get<std::string>());
    std::set<std::string> with_residual;
    for (const BandOfPlan& one : bandsOf(plan)) {
        bool below = false;
        for (const std::string& parent : one.parents)
            below = below || with_residual.count(parent) != 0;
        if (below || !one.band.at("residual").empty()) with_residual.insert(one.id);
        if (!below && without_ground.count(one.id) == 0) tools[one.id] = {};
    }
    for (const Json& operation : plan.at("operations")) {
        const auto found = tools.find(bandNamed(operation, plan));
        if (found == tools.end()) continue;
        if (found->second.empty() || found->second.back() != operation.at("tool"))
            found->second.push_back(operation.at("tool"));
    }
    return tools;
}

/// The shop's tools set out that far at most, so that deep features are cut in bands.
Json shortTools(double stick_out_mm) {
    std::ifstream file(kSource + "/samples/shop_metric_tools.json");
    Json library = Json::parse(file);
    for (Json& tool : library.at("tools")) {
        const double shorter_mm = tool.at("stick_out").get<double>() - stick_out_mm;
        if (tool.at("type") == "drill" || shorter_mm <= 0) continue;
        tool["stick_out"] = stick_out_mm;
        tool["flute_length"] = std::min(tool.at("flute_length").get<double>(), stick_out_mm);
        for (Json& cutting : tool.at("cutting"))
            for (const char* depth : {"step_down", "slot_step_down"})
                if (cutting.contains(depth))
                    cutting[depth] =
                        std::min(cutting[depth].get<double>(), tool["flute_length"].get<double>());
        if (tool.contains("shank"))
            tool["shank"]["from"] = std::min(tool["shank"].at("from").get<double>(), stick_out_mm);
        for (Json& cylinder : tool.at("holder"))
            for (const char* end : {"bottom", "top"})
                cylinder[end] = cylinder.at(end).get<double>() - shorter_mm;
    }
    return library;
}

/// The tools that the sensitivity has as best for a feature at a value.
Json bestAt(double value, const Json& feature) {
    for (const Json& range : feature.at("ranges"))
        if (range.at("from") <= value && (range.at("to").is_null() || value < range.at("to")))
            return range.at("tools");
    return {};
}

TEST_F(RankCommand, TheSequenceAtTheMachinesValueIsThePlans) {
    const std::string short_tools = write("short.json", shortTools(8).dump());
    const std::vector<std::pair<std::string, bool>> cases{
        {"bossed_pocket", false},         {"shoulder_block", false}, {"rounded_pocket", false},
        {"pocket_without_bosses", false}, {"nested_pockets", true},  {"rounded_pocket", true}};
    int compared = 0;
    int bands = 0;
    for (const auto& [part, with_short_tools] : cases) {
        std::vector<std::string> arguments{kSource + "/step_parts/" + part + ".step"};
        if (with_short_tools) arguments.insert(arguments.end(), {"--tools", short_tools});
        std::vector<std::string> plan{stepmillBinary(), "plan", "--json", "-o",
                                      (fs::path(folder_.path()) / "plan").string()};
        plan.insert(plan.end(), arguments.begin(), arguments.end());
        const ProgramRun run = runProgram(plan);
        ASSERT_LE(run.exit_code, 1) << part << ": " << run.err;
        const auto planned = unsharedTools(Json::parse(run.out));
        arguments.insert(arguments.end(), {"--sensitivity", "tool-change"});
        const Json sensitivity = rankJson(arguments).at("sensitivity");
        for (const Json& feature : sensitivity.at("features")) {
            const std::string id = feature.at("feature");
            if (planned.count(id) == 0) continue;
            EXPECT_EQ(bestAt(sensitivity.at("now"), feature), planned.at(id)) << part << ' ' << id;
            ++compared;
            bands += std::count(id.begin(), id.end(), '.') > 1 ? 1 : 0;
        }
    }
    EXPECT_GE(compared, 6);
    EXPECT_GE(bands, 1) << "some features should be cut in bands, and not in parts by depth";
}

TEST_F(RankCommand, WhatToBuyStartsFromThePlansTimes) {
    const std::string short_tools = write("short.json", shortTools(9).dump());
    const std::string part = kSource + "/step_parts/shoulder_block.step";
    // On an exact blank no feature takes another tool than its own best for company.
    const Json plan =
        Json::parse(runProgram({stepmillBinary(), "plan", part, "--tools", short_tools, "--stock-tolerance",
                                "0", "--json", "-o", (fs::path(folder_.path()) / "plan").string()})
                        .out);
    ASSERT_FALSE(unsharedTools(plan).empty());
    std::map<std::string, double> time_s;
    for (const BandOfPlan& one : bandsOf(plan))
        time_s[one.id] = one.band.at("time_s");
    const Json purchases =
        rankJson({part, "--tools", short_tools, "--stock-tolerance", "0", "--buy"}).at("purchases");
    ASSERT_EQ(purchases.size(), time_s.size());
    for (const Json& purchase : purchases)
        EXPECT_NEAR(purchase.at("time_s").get<double>(), time_s.at(purchase.at("feature")), 1e-5) << purchase;
}

TEST_F(RankCommand, GivesTheSameBytesForOneAndTwoThreads) {
    const std::vector<std::string> arguments{kSource + "/step_parts/rounded_pocket.step", "--sensitivity",
                                             "hourly-rate", "--buy", "--json"};
    std::vector<std::string> one = arguments;
    std::vector<std::string> two = arguments;
    one.insert(one.end(), {"--jobs", "1"});
    two.insert(two.end(), {"--jobs", "2"});
    const ProgramRun first = rank(one);
    EXPECT_EQ(first.exit_code, 0) << first.err;
    EXPECT_EQ(first.out, rank(two).out);
}

TEST_F(RankCommand, HelpHasExamples) {
    const ProgramRun run = rank({"--help"});
    EXPECT_EQ(run.exit_code, 0);
    for (const char* word : {"Examples", "--tool-change", "--sensitivity", "--buy", "TABLE.csv"})
        EXPECT_NE(run.out.find(word), std::string::npos) << word;
}

}  // namespace
}  // namespace stepmill::test
