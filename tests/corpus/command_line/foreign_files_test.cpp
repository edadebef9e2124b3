// Drawings as parts, and tool libraries of other programs in and out.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "support/planned_parts.h"
#include "support/run_program.h"
#include "support/text_file.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

const std::string kSource = STEPMILL_SOURCE_DIR;
const std::vector<std::string> kPocketWords{"--outline", "OUTLINE", "--thickness",
                                            "30",        "--depth", "POCKET=12"};

std::vector<double> areasOf(const PlannedPart& planned) {
    EXPECT_EQ(planned.run.exit_code, 0) << planned.run.err;
    std::vector<double> areas;
    const Json plan = Json::parse(slurp(planned.folder / "plan.json"));
    for (const Json& feature : plan.at("features"))
        for (const Json& band : feature.at("bands"))
            areas.push_back(band.at("area_mm2"));
    return areas;
}

TEST(DrawingCommand, PlansTheCommonPocketLikeTheSolid) {
    const std::vector<double> solid = areasOf(plannedPart(kSource + "/step_parts/rounded_pocket.step"));
    ASSERT_FALSE(solid.empty());
    for (const char* name : {"common_pocket.dxf", "common_pocket.svg"}) {
        const std::vector<double> drawn = areasOf(plannedPart(kSource + "/samples/" + name, kPocketWords));
        ASSERT_EQ(drawn.size(), solid.size()) << name;
        for (std::size_t i = 0; i < solid.size(); ++i)
            EXPECT_NEAR(drawn[i], solid[i], 1e-6 * solid[i]) << name;
    }
}

TEST(DrawingCommand, IsProvenFromItsDrawing) {
    const PlannedPart planned = plannedPart(kSource + "/samples/common_pocket.dxf", kPocketWords);
    std::vector<std::string> verify{stepmillBinary(), "verify", planned.folder.string(), "--part",
                                    kSource + "/samples/common_pocket.dxf"};
    verify.insert(verify.end(), kPocketWords.begin(), kPocketWords.end());
    const ProgramRun run = runProgram(verify);
    EXPECT_EQ(run.exit_code, 0) << run.out << run.err;
    verify.back() = "POCKET=11";
    EXPECT_EQ(runProgram(verify).exit_code, 2);
}

class ForeignFiles : public testing::Test {
  protected:
    ProgramRun run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), stepmillBinary());
        return runProgram(arguments);
    }

    std::string write(const std::string& name, const std::string& text) const {
        std::ofstream(path(name), std::ios::binary) << text;
        return path(name);
    }

    std::string path(const std::string& name) const { return (fs::path(folder_.path()) / name).string(); }

    /// Exit code 2, one line that holds the words, and no file.
    void expectRefused(const std::vector<std::string>& arguments, const std::string& words) const {
        const ProgramRun refused = run(arguments);
        EXPECT_EQ(refused.exit_code, 2) << refused.err;
        EXPECT_NE(refused.err.find(words), std::string::npos) << refused.err;
        EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
        EXPECT_FALSE(fs::exists(path("out.json")));
    }

    TemporaryFolder folder_;
};

TEST_F(ForeignFiles, DrawingsAskForWhatTheyDoNotSay) {
    const std::string drawing = kSource + "/samples/common_pocket.dxf";
    expectRefused({"inspect", drawing}, "--outline: expected the layer of the part's outer profile");
    expectRefused({"inspect", drawing, "--outline", "OUTLINE"}, "--thickness");
    expectRefused({"inspect", drawing, "--depth", "POCKET"}, "--depth: expected LAYER=DEPTH");
    expectRefused({"inspect", kSource + "/step_parts/rounded_pocket.step", "--depth", "A=1"},
                  "expected the curves of profiles alone, found 1 solid");
}

TEST_F(ForeignFiles, ToolsComeInAndGoOut) {
    const std::string shop = kSource + "/samples/shop_with_taps_tools.json";
    ASSERT_EQ(run({"tools", "export", shop, "--format", "fusion", "-o", path("fusion.json")}).exit_code, 0);
    const ProgramRun import = run({"tools", "import", path("fusion.json"), "-o", path("shop.json")});
    EXPECT_EQ(import.exit_code, 0) << import.out << import.err;
    EXPECT_EQ(run({"tools", "validate", path("shop.json")}).exit_code, 0);
    EXPECT_EQ(run({"tools", "list", path("shop.json")}).out, run({"tools", "list", shop}).out);
}

TEST_F(ForeignFiles, ToolsWithGapsAreWrittenWithExitCodeOne) {
    const std::string table = write("tool.tbl", "T1 P1 D6 ;drill\nT2 P2 D5\n");
    const ProgramRun import =
        run({"tools", "import", table, "-o", path("shop.json"), "--unit", "mm", "--cutting-data", "usual"});
    EXPECT_EQ(import.exit_code, 1) << import.err;
    EXPECT_NE(import.out.find("line 2: T2, left out: its type is not told"), std::string::npos) << import.out;
    EXPECT_NE(import.out.find("filled: stick_out"), std::string::npos) << import.out;
    const ProgramRun check = run({"tools", "check", path("shop.json")});
    EXPECT_EQ(check.exit_code, 1);
    EXPECT_NE(check.out.find("stick_out was never measured"), std::string::npos) << check.out;
}

TEST_F(ForeignFiles, BadToolsLeaveNothingBehind) {
    const std::string out = path("out.json");
    expectRefused(
        {"tools", "import", write("a.json", R"({"data": [{"type": "drill", "unit": "inches"}]})"), "-o", out},
        "a.json#/data/0: expected a tool's diameter");
    expectRefused({"tools", "import", write("t.tbl", "T1 D6 ;drill\n"), "-o", out},
                  "--unit: expected mm or inch");
    expectRefused({"tools", "import", write("b.tools", "PK"), "-o", out}, "b.tools, zip: expected a zip");
    expectRefused({"tools", "import", write("c.xyz", "x"), "-o", out}, "--format says what it is");
    expectRefused({"tools", "import", path("gone.csv"), "-o", out}, "gone.csv");
    expectRefused({"tools", "show", kSource + "/samples/shop_metric_tools.json", "none"},
                  "ID: expected a tool of shop_metric_tools.json");
}

TEST_F(ForeignFiles, ToolsAreShownToScale) {
    const ProgramRun show =
        run({"tools", "show", kSource + "/samples/shop_metric_tools.json", "T3", "-o", path("t3.svg")});
    EXPECT_EQ(show.exit_code, 0) << show.err;
    EXPECT_NE(show.out.find("T3 EM20"), std::string::npos);
    const std::string svg = slurp(path("t3.svg"));
    EXPECT_TRUE(svg.starts_with("<svg")) << svg.substr(0, 100);
    EXPECT_NE(svg.find("stick-out 56"), std::string::npos);
}

}  // namespace
}  // namespace stepmill::test
