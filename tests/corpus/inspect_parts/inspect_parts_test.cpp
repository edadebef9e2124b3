// What inspect writes, and when.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>

#include <nlohmann/json.hpp>

#include "support/run_program.h"
#include "support/text_file.h"

namespace stepmill::test {
namespace {

namespace fs = std::filesystem;

const fs::path kSource = STEPMILL_SOURCE_DIR;
TEST(InspectParts, NothingIsWrittenUnlessAskedForAndPagesAreWhole) {
    const TemporaryFolder folder;
    const fs::path out = fs::path(folder.path()) / "pages";
    const std::string part = (kSource / "step_parts/plate_with_holes.step").string();
    const ProgramRun quiet = runProgram({stepmillBinary(), "inspect", part});
    EXPECT_LE(quiet.exit_code, 1) << quiet.err;
    EXPECT_NE(quiet.out.find("Holes"), std::string::npos);
    EXPECT_FALSE(fs::exists("plate_with_holes-curves"));
    const ProgramRun run = runProgram({stepmillBinary(), "inspect", part, "-o", out.string()});
    EXPECT_LE(run.exit_code, 1) << run.err;
    EXPECT_TRUE(fs::exists(out / "inspect.json"));
    const std::string html = slurp(out / "inspect.html");
    EXPECT_NE(html.find("shade tint"), std::string::npos);
    EXPECT_NE(html.find("</html>"), std::string::npos);
}

TEST(InspectParts, ThreadsWhoseCoreAHoleIsAreAHint) {
    const TemporaryFolder folder;
    const std::string part = (kSource / "step_parts/plate_with_holes.step").string();
    const ProgramRun run = runProgram({stepmillBinary(), "inspect", part, "-o", folder.path()});
    EXPECT_LE(run.exit_code, 1) << run.err;
    EXPECT_NE(run.out.find("tap core of M8x1.25"), std::string::npos) << run.out;
    const std::string pages = folder.path();
    EXPECT_NE(slurp(fs::path(pages) / "inspect.html").find("M10x1.5"), std::string::npos);
    std::map<double, std::set<std::string>> hints;
    const auto inspected = nlohmann::json::parse(slurp(fs::path(pages) / "inspect.json"));
    for (const auto& hole : inspected.at("holes"))
        for (const auto& name : hole.at("tap_core_of"))
            hints[hole.at("diameter_mm")].insert(name);
    EXPECT_EQ(hints, (std::map<double, std::set<std::string>>{
                         {5.0, {"M6x1", "1/4-20 UNC"}}, {6.8, {"M8x1.25"}}, {8.5, {"M10x1.5"}}}));
}

TEST(InspectParts, TwoRunsGiveTheSameBytes) {
    const std::string part = (kSource / "step_parts/four_setups.step").string();
    const ProgramRun one = runProgram({stepmillBinary(), "inspect", part, "--json", "--jobs", "1"});
    const ProgramRun two = runProgram({stepmillBinary(), "inspect", part, "--json", "--jobs", "2"});
    EXPECT_EQ(one.out, two.out);
    EXPECT_FALSE(one.out.empty());
}

}  // namespace
}  // namespace stepmill::test
