// What the program says and how it ends, on arguments right and wrong.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include "support/expected_outcomes.h"
#include "support/planned_parts.h"
#include "support/run_program.h"
#include "support/text_file.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;

const std::string kSource = STEPMILL_SOURCE_DIR;
const std::string kPart = kSource + "/step_parts/shoulder_block.step";

void write(const fs::path& path, const std::string& text) {
    std::ofstream(path) << text;
}

ProgramRun plan(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {stepmillBinary(), "plan"});
    return runProgram(arguments);
}

/// Exit code 2, one message that holds every word, and no folder made.
void expectRefused(const ProgramRun& run, const fs::path& out, const std::vector<std::string>& words) {
    EXPECT_EQ(run.exit_code, 2) << run.err;
    EXPECT_EQ(run.out, "");
    for (const std::string& word : words)
        EXPECT_NE(run.err.find(word), std::string::npos) << "no '" << word << "' in: " << run.err;
    EXPECT_FALSE(fs::exists(out));
}

class CommandLine : public testing::Test {
  protected:
    TemporaryFolder folder_;
    fs::path out_ = fs::path(folder_.path()) / "plan";
    fs::path file(const std::string& name) const { return fs::path(folder_.path()) / name; }
};

TEST_F(CommandLine, HelpNamesEveryCommandAndTheExitCodes) {
    const ProgramRun run = runProgram({stepmillBinary(), "--help"});
    EXPECT_EQ(run.exit_code, 0);
    for (const char* word : {"plan", "rough", "inspect", "rank", "tools", "Exit codes"})
        EXPECT_NE(run.out.find(word), std::string::npos) << word;
}

TEST_F(CommandLine, RoughsAPartAndSaysWhatStays) {
    const ProgramRun run =
        runProgram({stepmillBinary(), "rough", kPart, "--allowance", "0.4", "-o", out_.string()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const ProgramRun proof = runProgram({stepmillBinary(), "verify", out_.string(), "--part", kPart});
    EXPECT_EQ(proof.exit_code, 0) << proof.out;
    EXPECT_NE(proof.out.find("(allowance)"), std::string::npos) << proof.out;
}

TEST_F(CommandLine, VerifyComparesFilesOfThePartWithThePartAlone) {
    for (const char* option : {"--stock", "--fixtures", "--holes"})
        expectRefused(runProgram({stepmillBinary(), "verify", out_.string(), option, "file"}), out_,
                      {option, "requires --part"});
}

TEST_F(CommandLine, RefusesAnAllowanceThatIsNone) {
    const ProgramRun run =
        runProgram({stepmillBinary(), "rough", kPart, "--floor-allowance", "7", "-o", out_.string()});
    expectRefused(run, out_, {"--floor-allowance", "0.01 to 5"});
}

TEST_F(CommandLine, PlansAPartWithDataOnStandardOutputOnly) {
    const ProgramRun run = plan({kPart, "-o", out_.string()});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.err, "");
    EXPECT_NE(run.out.find("Report: " + (out_ / "report.html").string()), std::string::npos);
}

TEST_F(CommandLine, WhatWasAskedForAndIsNotDoneIsAGap) {
    // No holes to screw through, no chamfer mill.
    for (const auto& [option, value] : {std::pair{"--hold", "screws"}, {"--break-edges", "0.3"}}) {
        const ProgramRun run = plan({kPart, "-o", out_.string(), option, value});
        EXPECT_EQ(run.exit_code, 1) << option << "\n" << run.out;
    }
}

TEST_F(CommandLine, AMaterialMayBeCalledAsTheMaterialsCallIt) {
    const ProgramRun run = plan({kPart, "-o", out_.string(), "--material", "S235JR", "--json"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(nlohmann::json::parse(run.out)["material"], "steel");
    expectRefused(plan({kPart, "-o", (out_ / "none").string(), "--material", "cheese"}), out_ / "none",
                  {"--material", "'cheese'", "aluminium, steel"});
}

TEST_F(CommandLine, JsonOnStandardOutputIsThePlanFile) {
    const ProgramRun run = plan({kPart, "-o", out_.string(), "--json"});
    EXPECT_EQ(run.out, slurp(out_ / "plan.json") + "\n");
}

class SameBytes : public testing::TestWithParam<ExpectedOutcome> {};

TEST_P(SameBytes, ForOneThreadAndForAll) {
    const PlannedPart with_all = plannedPart(GetParam().path);
    const PlannedPart with_one = plannedPart(GetParam().path, {"--jobs", "1"});
    ASSERT_EQ(with_one.run.exit_code, with_all.run.exit_code);
    for (const fs::directory_entry& file : fs::directory_iterator(with_all.folder)) {
        const fs::path name = file.path().filename();
        EXPECT_TRUE(slurp(with_one.folder / name) == slurp(file.path())) << name;
    }
}

const auto kPartName = [](const auto& row) { return testName(row.param); };
INSTANTIATE_TEST_SUITE_P(SampleParts, SameBytes,
                         testing::ValuesIn(withSlowProofs(expectedOf("step_parts"), false)), kPartName);
INSTANTIATE_TEST_SUITE_P(Slow, SameBytes, testing::ValuesIn(withSlowProofs(expectedOf("step_parts"), true)),
                         kPartName);

TEST_F(CommandLine, RefusesAMissingFile) {
    expectRefused(plan({file("no.step").string(), "-o", out_.string()}), out_, {"no.step"});
}

TEST_F(CommandLine, RefusesUnknownOptionsAndWords) {
    expectRefused(plan({kPart, "-o", out_.string(), "--fast"}), out_, {"--fast"});
    expectRefused(plan({kPart, "-o", out_.string(), "--setup", "up"}), out_, {"--setup", "'up'"});
    expectRefused(plan({kPart, "-o", out_.string(), "--stock-margin", "1,2"}), out_,
                  {"--stock-margin", "'1,2'"});
    expectRefused(plan({kPart, "-o", out_.string(), "--stock-tolerance", "21"}), out_,
                  {"--stock-tolerance", "0 to 20 mm", "21"});
    expectRefused(plan({kPart, "-o", out_.string(), "--stock-tolerance", "-1"}), out_,
                  {"--stock-tolerance", "0 to 20 mm", "-1"});
    expectRefused(plan({kPart, "-o", out_.string(), "--objective", "fun"}), out_, {"--objective"});
    expectRefused(plan({kPart, "-o", out_.string(), "--cost-model", "guess"}), out_,
                  {"--cost-model", "guess"});
    expectRefused(plan({kPart, "-o", out_.string(), "--solid", "9"}), out_, {"--solid", "9"});
    expectRefused(plan({kPart, "-o", out_.string(), "--finish-walls", "-0.3"}), out_,
                  {"--finish-walls", "0 or 0.01 to 5 mm", "-0.3"});
    expectRefused(plan({kPart, "-o", out_.string(), "--finish-floors", "300"}), out_,
                  {"--finish-floors", "300"});
}

TEST_F(CommandLine, PlansByTheModelThatIsAskedForAndSaysSo) {
    for (const char* model : {"paths", "yao", "lim"}) {
        const ProgramRun run = plan({kPart, "-o", out_.string(), "--cost-model", model, "--json"});
        EXPECT_EQ(run.exit_code, 0) << run.err;
        EXPECT_NE(run.out.find(std::string("\"cost_model\": \"") + model + "\""), std::string::npos) << model;
    }
}

TEST_F(CommandLine, ChoosesAStickOutFromARangeAndTellsIt) {
    write(file("tools.json"),
          R"({"format": 1, "unit": "mm", "tools": [{"id": "A", "number": 1, "type": "flat",
        "diameter": 10, "flute_length": 20, "flutes": 3, "centre_cutting": true, "stick_out": {"min": 22, "max": 60},
        "holder": [{"diameter": 40, "bottom": 60, "top": 90}], "cutting": [{"material": "aluminium", "step_over": 5,
        "step_down": 5, "feed": 1200, "plunge_feed": 300, "ramp_angle_deg": 3, "speed_rpm": 9000}]}]})");
    const ProgramRun run =
        plan({kPart, "-o", out_.string(), "--tools", file("tools.json").string(), "--json"});
    ASSERT_LE(run.exit_code, 1) << run.err;
    const std::string tools = run.out.substr(run.out.find("\"tools\": ["), 400);
    EXPECT_NE(tools.find("\"stick_out_range_mm\""), std::string::npos) << tools;
    EXPECT_EQ(tools.find("\"stick_out_mm\": 60.0"), std::string::npos)
        << "shorter than the longest: " << tools;
    write(file("tools.json"),
          R"({"format": 1, "unit": "mm", "tools": [{"id": "A", "number": 1, "type": "flat",
        "diameter": 10, "flute_length": 20, "stick_out": {"min": 70, "max": 60}, "cutting": []}]})");
    expectRefused(plan({kPart, "-o", file("no").string(), "--tools", file("tools.json").string()}),
                  file("no"), {"tools.json", "#/tools/0/stick_out/max", "at least the shortest"});
}

TEST_F(CommandLine, NamesTheMaterialsTheLibraryKnows) {
    expectRefused(plan({kPart, "-o", out_.string(), "--material", "cheese"}), out_,
                  {"'cheese'", "aluminium", "steel"});
}

TEST_F(CommandLine, ABrokenLibraryNamesFilePlaceAndExpectation) {
    write(file("tools.json"),
          R"({"format": 1, "unit": "mm", "tools": [{"id": "A", "number": 1, "type": "flat",
        "diameter": -6, "flute_length": 10, "flutes": 2, "centre_cutting": true, "stick_out": 20, "cutting": []}]})");
    expectRefused(plan({kPart, "-o", out_.string(), "--tools", file("tools.json").string()}), out_,
                  {"tools.json", "#/tools/0/diameter", "-6"});
}

TEST_F(CommandLine, ABrokenMachineNamesFileAndPlace) {
    write(file("mill.json"), "{\"format\": 1, \"name\": \"mill\"");
    expectRefused(plan({kPart, "-o", out_.string(), "--machine", file("mill.json").string()}), out_,
                  {"mill.json", "line 1"});
}

TEST_F(CommandLine, ABrokenHoleTableNamesFilePlaceAndExpectation) {
    write(file("holes.json"), R"({"format": 1, "unit": "mm", "holes": [
        {"diameter": {"min": 6, "max": 7}, "make": "tap", "thread": "M8x9"}]})");
    expectRefused(plan({kPart, "-o", out_.string(), "--holes", file("holes.json").string()}), out_,
                  {"holes.json#/holes/0/thread", "expected a thread such as M8", "M8x9"});
    expectRefused(plan({kPart, "-o", out_.string(), "--holes", file("none.json").string()}), out_,
                  {"none.json"});
}

TEST_F(CommandLine, AThreadThatNoTapCutsGivesAPlanWithReasonAndExitCodeOne) {
    const ProgramRun run = plan({kSource + "/step_parts/plate_with_holes.step", "-o", out_.string(),
                                 "--holes", kSource + "/samples/plate_holes.json"});
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_NE(run.out.find("no thread M8x1.25 is cut in 6 holes: the library has no tap M8x1.25"),
              std::string::npos)
        << run.out;
    EXPECT_TRUE(fs::exists(out_ / "plan.json"));
}

TEST_F(CommandLine, APlanWithThreadsIsTheSameBytesForOneThreadAndForAll) {
    std::vector<std::string> plans;
    for (const char* jobs : {"1", "2"}) {
        const ProgramRun run = plan({kSource + "/step_parts/plate_with_holes.step", "-o", out_.string(),
                                     "--holes", kSource + "/samples/plate_holes.json", "--tools",
                                     kSource + "/samples/shop_with_taps_tools.json", "--jobs", jobs});
        EXPECT_EQ(run.exit_code, 0) << run.err;
        plans.push_back(slurp(out_ / "plan.json") + slurp(out_ / "S1.ngc") + slurp(out_ / "sheets.html"));
    }
    EXPECT_EQ(plans[0], plans[1]);
    EXPECT_NE(plans[0].find("tapped M8x1.25 10.00 mm deep"), std::string::npos);
}

TEST_F(CommandLine, AnOutputFolderThatCannotBeMadeLeavesNothing) {
    write(file("in_the_way"), "");
    const ProgramRun run = plan({kPart, "-o", file("in_the_way/plan").string()});
    EXPECT_EQ(run.exit_code, 2);
    EXPECT_NE(run.err.find("in_the_way"), std::string::npos);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), fs::directory_iterator()), 1);
}

TEST_F(CommandLine, AStockThatDoesNotHoldThePartIsRefused) {
    const std::string small = kSource + "/step_parts/shoulder_block.step";
    const std::string large = kSource + "/step_parts/nested_pockets.step";
    expectRefused(plan({large, "-o", out_.string(), "--stock", small}), out_, {"stock"});
}

TEST_F(CommandLine, AStockFileHasNoMargin) {
    const std::string stock = kSource + "/step_parts/shoulder_block.step";
    expectRefused(plan({kPart, "-o", out_.string(), "--stock", stock, "--stock-margin", "1,1,1"}), out_,
                  {"--stock-margin", "stock file"});
}

TEST_F(CommandLine, EndsAtItsTimeLimitAndLeavesNothing) {
    const ProgramRun run =
        plan({kSource + "/step_parts/bossed_pocket.step", "-o", out_.string(), "--timeout", "0.05"});
    expectRefused(run, out_, {"stopped after 0.05 s", "--timeout"});
    EXPECT_TRUE(fs::is_empty(folder_.path()));
}

TEST_F(CommandLine, AFeatureNoToolFitsGivesAPlanWithReasonAndExitCodeOne) {
    write(file("big.json"),
          R"({"format": 1, "unit": "mm", "tools": [{"id": "F80", "number": 1, "type": "flat",
        "diameter": 80, "corner_radius": 0, "flute_length": 40, "flutes": 4, "centre_cutting": true, "stick_out": 60,
        "shank": {"diameter": 32, "from": 40}, "holder": [],
        "cutting": [{"material": "aluminium", "step_over": 30, "step_down": 5, "feed": 1000, "plunge_feed": 300,
                     "ramp_angle_deg": 3, "speed_rpm": 3000}], "price": 1, "life_min": 60, "description": "",
        "vendor": "", "product_id": ""}]})");
    const ProgramRun run = plan({kSource + "/step_parts/rounded_pocket.step", "-o", out_.string(), "--tools",
                                 file("big.json").string()});
    EXPECT_EQ(run.exit_code, 1) << run.err;
    EXPECT_NE(run.out.find("none fits"), std::string::npos);
    EXPECT_NE(run.out.find("needs"), std::string::npos);
    EXPECT_TRUE(fs::exists(out_ / "plan.json"));
}

TEST_F(CommandLine, ValidatesToolLibraries) {
    const ProgramRun good =
        runProgram({stepmillBinary(), "tools", "validate", kSource + "/samples/dsouza2006_tools.json"});
    EXPECT_EQ(good.exit_code, 0) << good.err;
    EXPECT_NE(good.out.find("8 tools"), std::string::npos);

    write(file("tools.json"), "{\"format\": 1, \"unit\": \"feet\", \"tools\": []}");
    const ProgramRun bad = runProgram({stepmillBinary(), "tools", "validate", file("tools.json").string()});
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_NE(bad.err.find("tools.json#/unit"), std::string::npos) << bad.err;
}

}  // namespace
}  // namespace stepmill::test
